// Converts HTML pages to PDF.
#pragma once

#include <filesystem>
#include <string>

namespace abstand::report {

/// Throws UsageError, with the name of the option, if neither WeasyPrint nor wkhtmltopdf is installed; called
/// before the page is made.
void needPdfConverter(const std::string& option = "--pdf");

/// Converts one of our pages with WeasyPrint, otherwise with wkhtmltopdf. The file is written completely or
/// not at all. Throws UsageError without a converter, and WriteError if it fails or takes longer than two
/// minutes.
void writePdf(const std::filesystem::path& html, const std::filesystem::path& file);

}  // namespace abstand::report
