// Pairs of stored results as a table.
#pragma once

#include <filesystem>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::cli {

/// Writes a CSV row for each frame and pair of the recordings, which have result files; columns name their
/// units. Unknown points are empty, unknown uncertainties "inf", unknown clearances "-inf". Reads and writes
/// some frames at a time. Returns the number of rows. Throws ParseError, WriteError.
std::size_t writePairTable(const std::vector<tune::TunedRecording>& recordings,
                           const std::filesystem::path& file);

}  // namespace abstand::cli
