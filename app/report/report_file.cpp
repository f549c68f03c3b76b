#include "app/report/report_file.hpp"

#include "app/report/pdf.hpp"
#include "core/base/temporary_folder.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {

bool isPdf(const std::filesystem::path& file) { return text::lowerCase(file.extension().string()) == ".pdf"; }

void writePdfReport(const tune::TuneAnswer& answer, const TuneReportOptions& options,
                    const std::filesystem::path& file) {
  const TemporaryFolder folder;
  const std::filesystem::path page = folder.path() / "page.html";
  writeTuneReport(answer, options, page);
  writePdf(page, file);
}

void writeReportFile(const tune::TuneAnswer& answer, const TuneReportOptions& options,
                     const std::filesystem::path& file) {
  isPdf(file) ? writePdfReport(answer, options, file) : writeTuneReport(answer, options, file);
}

}  // namespace abstand::report
