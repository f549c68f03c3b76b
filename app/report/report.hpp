// The verification report, a page for people.
#pragma once

#include <filesystem>
#include <string>

#include "core/verify/check.hpp"

namespace abstand::report {

/// One HTML page with tables and plots; no script, nothing from outside, light and dark by the reader's
/// choice. It holds no date and no machine, so that pages of two releases differ only in what changed. Throws
/// UsageError when the file cannot be written.
void writeReport(const std::vector<verify::CheckResult>& results, const verify::VerifyOptions& options,
                 const std::string& version, const std::filesystem::path& file);

}  // namespace abstand::report
