#include "app/report/pdf.hpp"

#include "app/report/child_program.hpp"
#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/output_file.hpp"
#include "core/base/temporary_folder.hpp"
#include "core/base/text_file.hpp"
#include "core/base/write_error.hpp"

namespace abstand::report {
namespace {

constexpr double kMaxSeconds = 120.0;
constexpr std::uintmax_t kMaxPdfBytes = std::uintmax_t{1} << 30;

/// A PDF converter and its options.
struct Converter {
  const char* name;
  std::vector<std::string> options;
};

const std::vector<Converter>& converters() {
  static const std::vector<Converter> all{
      {"weasyprint", {"--quiet"}},
      {"wkhtmltopdf",
       {"--quiet", "--disable-javascript", "--print-media-type", "--page-size", "A4", "--margin-top", "15mm",
        "--margin-bottom", "15mm", "--margin-left", "15mm", "--margin-right", "15mm"}}};
  return all;
}

struct FoundConverter {
  const Converter* converter;
  std::filesystem::path program;
};

FoundConverter foundConverter(const std::string& option) {
  for (const Converter& converter : converters())
    if (const auto program = findProgram(converter.name)) return {&converter, *program};
  throw UsageError(
      option +
      ": found neither weasyprint nor wkhtmltopdf, expected one of them for a PDF: apt-get install "
      "weasyprint");
}

}  // namespace

void needPdfConverter(const std::string& option) { foundConverter(option); }

void writePdf(const std::filesystem::path& html, const std::filesystem::path& file) {
  const FoundConverter found = foundConverter("--pdf");
  OutputFile out(file);
  const TemporaryFolder folder;
  const std::filesystem::path made = folder.path() / "page.pdf";
  std::vector<std::string> arguments = found.converter->options;
  arguments.insert(arguments.end(), {html.string(), made.string()});
  const ProgramEnd end = runProgram(found.program, arguments, kMaxSeconds);
  if (end.timed_out)
    throw WriteError(file.string(), found.program.string() + " takes longer than two minutes");
  if (end.code != 0)
    throw WriteError(file.string(), found.program.string() + " fails" +
                                        (end.last_words.empty() ? "" : ": " + end.last_words));
  const InputLogPause pause;
  const std::string pdf = readFile(made, kMaxPdfBytes);
  if (pdf.compare(0, 5, "%PDF-") != 0)
    throw WriteError(file.string(), found.program.string() + " makes something else than PDF");
  out.stream() << pdf;
  out.commit();
}

}  // namespace abstand::report
