// Reading untrusted files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace abstand {

/// Throws ParseError if the file is missing or not a regular file: a directory, a device, or a pipe, on which
/// reading would block forever. Records the file as an input (input_log.hpp).
void needRegularFile(const std::filesystem::path& file);

/// The whole file. Throws ParseError for a file that is missing, a directory, unreadable, or larger
/// than `max_bytes`. An empty file is an error too, unless `may_be_empty`.
std::string readFile(const std::filesystem::path& file, std::uintmax_t max_bytes = std::uintmax_t{2} << 30,
                     bool may_be_empty = false);

}  // namespace abstand
