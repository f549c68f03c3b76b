#include "app/cli/question_arguments.hpp"

#include <algorithm>

#include "app/cli/tune_arguments.hpp"
#include "app/cli/tune_speeds.hpp"
#include "app/report/pdf.hpp"
#include "app/report/report_file.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {

void QuestionArguments::add(CLI::App& command, CommandLine& line) {
  command.add_option("--margins", margins, "FROM:TO:STEP in metres (default: 0:0.5:0.05)");
  command.add_option("--margin-set", margin_sets,
                     "margins files by part, link and pair to evaluate as well (docs/margins.md)");
  line.output(
      command.add_option("--margins-out", margins_out, "writes the smallest safe margins as a margins file"));
  command.add_option("--by", by, "resolution of --margins-out: part, link or pair (default: part)")
      ->check(CLI::IsMember({"part", "link", "pair"}));
  command.add_option("--segment", segment,
                     "length in s of the program segments that get one speed each (default: 1)");
  addSpeedRule(command, speed_rule);
  line.output(command.add_option(
      "--report", report,
      "report for signature: HTML, or PDF if the name ends with .pdf (needs the package weasyprint or "
      "wkhtmltopdf)"));
}

tune::TuneQuestions QuestionArguments::questions() const {
  tune::TuneQuestions questions{marginList(margins), segmentLength(segment), {}, speedRule(speed_rule)};
  if (abstand::report::isPdf(report)) abstand::report::needPdfConverter("--report");
  for (const std::string& file : margin_sets) questions.margin_sets.push_back(tune::loadMarginRules(file));
  return questions;
}

void QuestionArguments::writeMargins(const tune::TuneAnswer& answer) const {
  if (margins_out.empty()) return;
  const auto set = std::find_if(answer.strategies.begin(), answer.strategies.end(),
                                [&](const tune::StrategyOutcome& s) { return s.rules.name == "per_" + by; });
  if (set == answer.strategies.end())
    throw UsageError("--margins-out: found a " + by + " without a sufficient margin, expected one for each");
  writeFile(margins_out, tune::marginRulesText(set->rules));
}

}  // namespace abstand::cli
