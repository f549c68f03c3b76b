// Terms of the protective distance of stored results as a table.
#pragma once

#include <filesystem>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

/// Writes a CSV row for each frame and body part of the recordings, which have result files: the terms of S_p
/// of the link for which it exceeds the clearance most, the excess, and the permitted speed; columns name
/// their units. Fields are empty where no link moves towards the part. Unknown clearances are "-inf". Reads
/// and writes some frames at a time. Returns the number of rows. Throws ParseError, WriteError.
std::size_t writeSeparationTable(const tune::TuneAnswer& answer, const std::filesystem::path& file);

}  // namespace abstand::cli
