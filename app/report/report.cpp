// The verification report, a page for people.
#include "app/report/report.hpp"

#include <algorithm>

#include "app/report/svg_plot.hpp"
#include "core/base/output_file.hpp"
#include "core/verify/check_tools.hpp"

namespace abstand::report {
namespace {

// Colours: Okabe and Ito's, which colour-blind readers tell apart; dashes tell them apart in print.
constexpr const char* kStyle = R"(<style>
:root{color-scheme:light dark;--text:#1b1b1b;--back:#fff;--soft:#666;--rule:#d5d5d5;--bad:#b34700;--good:#00694d;
--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#cc79a7;--c4:#b58900;--c5:#56b4e9;--c6:#7a5195;--c7:#555;--c8:#a00}
@media (prefers-color-scheme:dark){:root{--text:#e6e6e6;--back:#16181b;--soft:#a0a0a0;--rule:#3a3d42;--bad:#ff9b5e;
--good:#4fd1a5;--c0:#56b4e9;--c1:#ff9b5e;--c2:#4fd1a5;--c3:#e5a3c8;--c4:#f0e442;--c5:#8ecbf0;--c6:#c1a0e0;--c7:#aaa;
--c8:#ff7a7a}}
body{font:16px/1.5 system-ui,sans-serif;color:var(--text);background:var(--back);max-width:64rem;margin:2rem auto;
padding:0 1rem}
h2{margin-top:2.5rem;border-bottom:1px solid var(--rule)}
.wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}
td,th{padding:.15rem .7rem .15rem 0;text-align:left;border-bottom:1px solid var(--rule);vertical-align:top}
td:first-child{white-space:nowrap}th{color:var(--soft);font-weight:600}.soft{color:var(--soft)}
.passed{color:var(--good);font-weight:600}.failed{color:var(--bad);font-weight:600}
a{color:inherit}svg{width:100%;max-width:45rem;display:block;margin:1rem 0}
svg text{fill:var(--text);font:12px system-ui,sans-serif}
.axis{stroke:var(--text)}.grid{stroke:var(--rule)}polyline{fill:none;stroke-width:1.6}
.s0{stroke:var(--c0)}.s1{stroke:var(--c1);stroke-dasharray:7 3}.s2{stroke:var(--c2);stroke-dasharray:2 3}
.s3{stroke:var(--c3);stroke-dasharray:9 3 2 3}.s4{stroke:var(--c4)}.s5{stroke:var(--c5);stroke-dasharray:7 3}
.s6{stroke:var(--c6);stroke-dasharray:2 3}.s7{stroke:var(--c7);stroke-dasharray:9 3 2 3}.s8{stroke:var(--c8)}
</style>)";

std::string cell(const std::string& text, const char* tag = "td") {
  return std::string("<") + tag + ">" + escaped(text) + "</" + tag + ">";
}

std::string verdict(bool passed) {
  return passed ? "<span class=\"passed\">passed</span>" : "<span class=\"failed\">failed</span>";
}

std::string link(const verify::CheckResult& r) {
  return "<a href=\"#" + escaped(r.name) + "\">" + escaped(r.name) + "</a>";
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

std::string table(const verify::Table& table) {
  if (table.rows.empty()) return {};
  std::string html = "<div class=\"wide\"><table><tr>";
  for (const std::string& name : table.header) html += cell(name, "th");
  html += "</tr>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& value : row) html += cell(value);
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string section(const verify::CheckResult& r) {
  std::string html = "<h2 id=\"" + escaped(r.name) + "\">" + escaped(r.name) + " " + verdict(r.passed) +
                     "</h2>\n<p>" + escaped(r.what) + "</p>\n<p class=\"soft\">" + escaped(r.quantity) +
                     ": worst " + verify::shortNumber(r.worst) + ", limit " + verify::shortNumber(r.limit) +
                     ". " + escaped(r.reason) + "</p>\n" + table(r.table);
  for (const verify::Plot& plot : r.plots) html += svgPlot(plot);
  return html;
}

}  // namespace

void writeReport(const std::vector<verify::CheckResult>& results, const verify::VerifyOptions& options,
                 const std::string& version, const std::filesystem::path& file) {
  const auto failed = std::ranges::count_if(results, [](const verify::CheckResult& r) { return !r.passed; });
  OutputFile out(file);
  out.stream() << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                  "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
                  "<title>Abstand: verification</title>\n"
               << kStyle << "</head><body>\n<h1>Abstand " << escaped(version) << ": verification</h1>\n<p>"
               << results.size() << " checks, "
               << (failed == 0 ? std::string("<span class=\"passed\">all passed</span>")
                               : "<span class=\"failed\">" + std::to_string(failed) + " failed</span>")
               << ". Each number is a measurement per pose; a check passes when none is beyond its limit. "
                  "docs/verification.md says how to read and repeat them.</p>\n"
               << summary(results);
  for (const verify::CheckResult& r : results) out.stream() << section(r);
  out.stream() << "<p class=\"soft\">Made by <code>abstand verify --poses " << options.poses << " --seed "
               << options.seed << (options.quick ? " --quick" : "") << "</code>, version " << escaped(version)
               << ". The numbers do not depend on the number of threads. An analysis tool, not a safety "
                  "function.</p>\n</body></html>\n";
  out.commit();
}

}  // namespace abstand::report
