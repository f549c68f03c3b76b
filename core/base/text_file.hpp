// Reading files that come from strangers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace abstand {

/// The whole file. Throws ParseError for a file that is missing, a directory, unreadable, or larger
/// than `most_bytes`. An empty file is an error too, unless `may_be_empty`.
std::string readFile(const std::filesystem::path& file, std::uintmax_t most_bytes = std::uintmax_t{2} << 30,
                     bool may_be_empty = false);

}  // namespace abstand
