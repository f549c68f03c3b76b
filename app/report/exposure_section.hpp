// Exposure section of the margin report, and a page of its own.
#pragma once

#include <filesystem>
#include <string>

#include "app/tune/exposure_table.hpp"

namespace abstand::report {

/// HTML with heading: definitions, maps of body and room, tables of parts, links, pairs and program segments.
std::string exposureSection(const tune::ExposureTable& table);

struct ExposurePageOptions {
  std::string version;  ///< of the program
  std::size_t recordings{0};
};

/// One HTML page like writeTuneReport(). Throws UsageError and WriteError.
void writeExposurePage(const tune::ExposureTable& table, const ExposurePageOptions& options,
                       const std::filesystem::path& file);

}  // namespace abstand::report
