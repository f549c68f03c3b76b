// HTML page of the verification report.
#pragma once

#include <filesystem>
#include <string>

#include "core/verify/check.hpp"

namespace abstand::report {

/// One HTML page with tables and plots; self-contained, no scripts, light and dark by the reader's
/// preference. Without date and machine, so that pages of two releases differ only in what changed. Throws
/// UsageError if the file cannot be written.
void writeReport(const std::vector<verify::CheckResult>& results, const verify::VerifyOptions& options,
                 const std::string& version, const std::filesystem::path& file);

}  // namespace abstand::report
