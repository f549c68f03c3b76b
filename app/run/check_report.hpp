// What `check` leaves behind for other programs and for people.
#pragma once

#include <filesystem>
#include <string>

#include "app/run/distance_check.hpp"

namespace abstand {

/// JUnit XML: one test case a violation, or a single passed one. Throws UsageError.
void writeJunit(const CheckResult& result, const std::string& scene, const std::filesystem::path& file);

/// One HTML page without outside references. Throws UsageError.
void writeHtmlReport(const CheckResult& result, const std::string& scene, double limit,
                     const std::filesystem::path& file);

}  // namespace abstand
