#include "app/report/report_file.hpp"

#include "app/report/pdf.hpp"
#include "core/base/temporary_folder.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {

bool isPdf(const std::filesystem::path& file) { return text::lowerCase(file.extension().string()) == ".pdf"; }

void writeReportFile(const tune::TuneAnswer& answer, const TuneReportOptions& options,
                     const std::filesystem::path& file) {
  if (!isPdf(file)) return writeTuneReport(answer, options, file);
  const TemporaryFolder folder;
  const std::filesystem::path page = folder.path() / "page.html";
  writeTuneReport(answer, options, page);
  writePdf(page, file);
}

}  // namespace abstand::report
