// Predicted contacts of stored results as a table.
#pragma once

#include <filesystem>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

/// Writes a CSV row for each frame and body part of the recordings, which have result files: the hardest
/// contact that could occur (FrameContact); columns name their units. Fields are empty where nothing near
/// closes in; a share is "inf" where contact is excluded, and with empty fields before it where the part is
/// not seen. Reads and writes some frames at a time. Returns the number of rows. Throws ParseError,
/// WriteError.
std::size_t writeContactTable(const tune::TuneAnswer& answer, const std::filesystem::path& file);

}  // namespace abstand::cli
