// An HTML page as PDF.
#pragma once

#include <filesystem>

namespace abstand::report {

/// Throws UsageError where neither WeasyPrint nor wkhtmltopdf is installed: before the page is made.
void needPdfConverter();

/// Converts a page of ours with WeasyPrint, else with wkhtmltopdf. The file appears whole or not at all.
/// Throws UsageError without a converter, and WriteError where it fails or takes longer than two minutes.
void writePdf(const std::filesystem::path& html, const std::filesystem::path& file);

}  // namespace abstand::report
