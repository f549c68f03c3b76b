// The margin report as a file of the kind that its name says.
#pragma once

#include <filesystem>

#include "app/report/tune_report.hpp"

namespace abstand::report {

/// The name ends with `.pdf`, in any case.
bool isPdf(const std::filesystem::path& file);

/// The page of writeTuneReport() as PDF, whatever the name is. The file is written completely or not at all.
/// Throws as writeTuneReport() and writePdf().
void writePdfReport(const tune::TuneAnswer& answer, const TuneReportOptions& options,
                    const std::filesystem::path& file);

/// An HTML page, or for isPdf() a PDF; likewise.
void writeReportFile(const tune::TuneAnswer& answer, const TuneReportOptions& options,
                     const std::filesystem::path& file);

}  // namespace abstand::report
