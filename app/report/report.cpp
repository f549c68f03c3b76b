// HTML page of the verification report.
#include "app/report/report.hpp"

#include <algorithm>

#include "app/report/page.hpp"
#include "app/report/svg_plot.hpp"
#include "core/base/output_file.hpp"
#include "core/text/escaped_xml.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::report {
namespace {

std::string verdict(bool passed) {
  return passed ? "<span class=\"passed\">passed</span>" : "<span class=\"failed\">failed</span>";
}

std::string link(const verify::CheckResult& r) {
  return "<a href=\"#" + text::escapedXml(r.name) + "\">" + text::escapedXml(r.name) + "</a>";
}

std::string summary(const std::vector<verify::CheckResult>& results) {
  std::string html = "<div class=\"wide\"><table><tr>";
  for (const char* name : {"check", "poses", "worst", "p50", "p99", "limit", "breaches", ""})
    html += cell(name, "th");
  html += "</tr>\n";
  for (const verify::CheckResult& r : results) {
    html += "<tr><td>" + link(r) + "</td>" + cell(std::to_string(r.poses));
    for (const double v : {r.worst, r.p50, r.p99, r.limit}) html += cell(verify::shortNumber(v));
    html += cell(std::to_string(r.breaches)) + "<td>" + verdict(r.passed) + "</td></tr>\n";
  }
  return html + "</table></div>\n";
}

std::string section(const verify::CheckResult& r) {
  std::string html = "<h2 id=\"" + text::escapedXml(r.name) + "\">" + text::escapedXml(r.name) + " " +
                     verdict(r.passed) + "</h2>\n<p>" + text::escapedXml(r.what) +
                     "</p>\n<p class=\"soft\">" + text::escapedXml(r.quantity) + ": worst " +
                     verify::shortNumber(r.worst) + ", limit " + verify::shortNumber(r.limit) + ". " +
                     text::escapedXml(r.reason) + "</p>\n" +
                     (r.table.rows.empty() ? std::string() : htmlTable(r.table.header, r.table.rows));
  for (const verify::Plot& plot : r.plots) html += svgPlot(plot);
  return html;
}

}  // namespace

void writeReport(const std::vector<verify::CheckResult>& results, const verify::VerifyOptions& options,
                 const std::string& version, const std::filesystem::path& file) {
  const auto failed = std::ranges::count_if(results, [](const verify::CheckResult& r) { return !r.passed; });
  OutputFile out(file);
  out.stream() << pageBegin("Abstand: verification") << "<h1>Abstand " << text::escapedXml(version)
               << ": verification</h1>\n<p>" << results.size() << " checks, "
               << (failed == 0 ? std::string("<span class=\"passed\">all passed</span>")
                               : "<span class=\"failed\">" + std::to_string(failed) + " failed</span>")
               << ". Each number is a measurement per pose; a check passes when none is beyond its limit. "
                  "docs/verification.md says how to read and repeat them.</p>\n"
               << summary(results);
  for (const verify::CheckResult& r : results) out.stream() << section(r);
  out.stream() << "<p class=\"soft\">Made by <code>abstand verify --poses " << options.poses << " --seed "
               << options.seed << (options.quick ? " --quick" : "") << "</code>, version "
               << text::escapedXml(version)
               << ". The numbers do not depend on the number of threads. An analysis tool, not a safety "
                  "function.</p>\n"
               << pageEnd();
  out.commit();
}

}  // namespace abstand::report
