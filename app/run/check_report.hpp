// Report files of `check`.
#pragma once

#include <filesystem>
#include <string>

#include "app/run/distance_check.hpp"

namespace abstand::run {

/// JUnit XML: a failed test case for each violation, each unproven pair (`strict`) and each reservation that
/// fails the check, with its reason; or a single passed one. All reservations are in the suite's output.
/// Throws UsageError.
void writeJunit(const CheckResult& result, const std::string& scene, bool strict,
                const std::filesystem::path& file);

/// A self-contained HTML page. Throws UsageError.
void writeHtmlReport(const CheckResult& result, const std::string& scene, double limit, bool strict,
                     const std::filesystem::path& file);

}  // namespace abstand::run
