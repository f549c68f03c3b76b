// abstand report: report files from results of `tune --out`.
#include "app/cli/command_line.hpp"
#include "app/cli/tune_arguments.hpp"
#include "app/cli/version.hpp"
#include "app/report/pdf.hpp"
#include "app/report/report_file.hpp"
#include "app/report/tune_report.hpp"
#include "app/run/junit.hpp"
#include "app/tune/margin_events.hpp"
#include "app/tune/speed_table.hpp"
#include "app/tune/tune_answer.hpp"
#include "core/base/error.hpp"

namespace abstand::cli {
namespace {

struct ReportArguments {
  std::vector<std::string> folders;
  std::string html, pdf, junit, margin, margins{"0:0.5:0.05"}, restart_time, segment;
  bool strict{false};
};

/// A test case for each run: passed if no stop at this margin is missed, and nothing was unknown.
run::JunitSuite suiteOf(const std::vector<tune::TunedRecording>& recordings, double margin,
                        const margin::MarginOptions& options, bool strict) {
  run::JunitSuite suite{format("abstand margin %.0f mm", 1e3 * margin), "margin", {}, {}};
  for (const tune::TunedRecording& recording : recordings) {
    run::JunitCase test{recording.recording, {}, {}};
    const auto fail = [&](const std::string& type, const std::string& reason) {
      if (test.reason.empty()) test.type = type;
      test.reason += (test.reason.empty() ? "" : "; ") + reason;
    };
    for (const tune::MarginEvent& e : tune::marginEvents(recording, margin, options))
      if (e.missed)
        fail("missed_stop",
             format("%s to %s at %.3f s: missed stop", recording.pass.parts[e.part].part.c_str(),
                    recording.pass.links[e.link].c_str(), e.t0));
    for (const run::Reservation& r : recording.reservations) {
      if (run::failing(r, strict)) fail(r.kind, r.text);
      suite.output += recording.recording + ": " + r.kind + ": " + r.text + "\n";
    }
    suite.cases.push_back(std::move(test));
  }
  return suite;
}

int runReport(const CommandLine& line, const ReportArguments& args) {
  if (args.html.empty() && args.pdf.empty() && args.junit.empty())
    throw UsageError("found neither --html, --pdf nor --junit, expected a file to write");
  if (args.junit.empty() != args.margin.empty())
    throw UsageError("--junit and --margin: found one alone, expected both: the test evaluates that margin");
  if (!args.pdf.empty()) report::needPdfConverter();
  tune::TuneAnswer answer = tune::mergedAnswer({args.folders.begin(), args.folders.end()});
  takeRestartTime(args.restart_time, answer.options);
  nlohmann::ordered_json document{{"recordings", answer.recordings.size()}};
  std::string text = format("%zu runs", answer.recordings.size());
  if (!args.html.empty() || !args.pdf.empty()) {
    tune::answerQuestions({marginList(args.margins), segmentLength(args.segment), {}}, answer);
    const report::TuneReportOptions page{kVersion, "results of tune", {}};
    if (!args.html.empty()) report::writeTuneReport(answer, page, args.html);
    if (!args.pdf.empty()) report::writePdfReport(answer, page, args.pdf);
  }
  if (!args.junit.empty()) {
    const double margin = numberWithin(args.margin, "--margin", 0.0, 10.0, "m");
    const run::JunitSuite suite = suiteOf(answer.recordings, margin, answer.options.margins(), args.strict);
    run::writeJunit(suite, args.junit);
    const auto failed = std::count_if(suite.cases.begin(), suite.cases.end(),
                                      [](const run::JunitCase& c) { return !c.reason.empty(); });
    document["margin"] = margin;
    document["failed"] = failed;
    text += format(", %td of them not passed at %.0f mm", failed, 1e3 * margin);
  }
  line.print(document, text + "\n");
  return kDone;
}

}  // namespace

void addReport(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "report", "reports tune results as an HTML page for signature, and as JUnit XML",
                 "abstand report results --html report.html --junit result.xml --margin 0.2");
  auto args = std::make_shared<ReportArguments>();
  command->add_option("FOLDER", args->folders, "folders of `tune --out`")->required();
  line.output(command->add_option("--html", args->html, "HTML report for signature"));
  line.output(command->add_option("--pdf", args->pdf,
                                  "the same page as PDF; needs the package weasyprint or wkhtmltopdf"));
  line.output(command->add_option(
      "--junit", args->junit, "JUnit XML: a test for each run, failed where a stop at --margin is missed"));
  command->add_option("--margin", args->margin, "margin in m that --junit tests");
  command->add_flag("--strict", args->strict,
                    "--junit fails for every reservation that affects safety, as `check --strict`");
  command->add_option("--margins", args->margins,
                      "of the page: FROM:TO:STEP in metres (default: 0:0.5:0.05)");
  command->add_option("--restart-time", args->restart_time,
                      "restart time in s: from the end of an intrusion until the robot resumes (default: 0)");
  command->add_option("--segment", args->segment,
                      "length in s of the program segments that get one speed each (default: 1)");
  command->callback([&line, args] { line.run = [&line, args] { return runReport(line, *args); }; });
}

}  // namespace abstand::cli
