#include "app/run/check_report.hpp"

#include <algorithm>
#include <cmath>

#include "app/run/junit.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "core/text/escaped_xml.hpp"

namespace abstand::run {
namespace {

std::string metres(double value) { return formatDouble(value) + " m"; }

std::string sentence(const Violation& v) {
  std::string text = v.a + " to " + v.b + ": " + metres(v.min_distance) + ", limit " + metres(v.limit);
  if (std::isinf(v.uncertainty))
    text += "; one of them was never tracked";
  else if (v.uncertainty > 0.0)
    text += " plus " + metres(v.uncertainty) + " of pose uncertainty";
  text += ", from " + formatDouble(v.start) + " s to " + formatDouble(v.end) + " s";
  return v.recording.empty() ? text : text + ", " + v.recording;
}

std::string reservationLine(const Reservation& r) {
  return r.recording.empty() ? r.text : r.text + ", " + r.recording;
}

void reservationTable(std::ostream& out, const std::vector<Reservation>& rows, bool strict) {
  out << "<h2>Reservations</h2>\n";
  if (rows.empty()) {
    out << "<p>None.</p>\n";
    return;
  }
  out << "<table><tr><th>kind</th><th>reason</th><th>recording</th></tr>\n";
  for (const Reservation& r : rows)
    out << "<tr><td" << (failing(r, strict) ? " class=\"broken\"" : "") << ">" << text::escapedXml(r.kind)
        << "</td><td>" << text::escapedXml(r.text) << "</td><td>" << text::escapedXml(r.recording)
        << "</td></tr>\n";
  out << "</table>\n";
}

void table(std::ostream& out, const char* title, const std::vector<Violation>& rows) {
  out << "<h2>" << title << "</h2>\n";
  if (rows.empty()) {
    out << "<p>None.</p>\n";
    return;
  }
  out << "<table><tr><th>A</th><th>B</th><th>from [s]</th><th>to [s]</th><th>smallest distance [m]</th>"
         "<th>limit [m]</th><th>recording</th></tr>\n";
  for (const Violation& v : rows)
    out << "<tr><td>" << text::escapedXml(v.a) << "</td><td>" << text::escapedXml(v.b) << "</td><td>"
        << formatDouble(v.start) << "</td><td>" << formatDouble(v.end) << "</td><td>"
        << formatDouble(v.min_distance) << "</td><td>" << formatDouble(v.limit) << "</td><td>"
        << text::escapedXml(v.recording) << "</td></tr>\n";
  out << "</table>\n";
}

}  // namespace

void writeJunit(const CheckResult& result, const std::string& scene, bool strict,
                const std::filesystem::path& file) {
  JunitSuite suite{"abstand check " + scene, scene, {}, {}};
  for (const Violation& v : result.violations)
    suite.cases.push_back({v.a + " to " + v.b, "distance", sentence(v)});
  if (strict)
    for (const Violation& v : result.unproven)
      suite.cases.push_back({v.a + " to " + v.b, "not_proven",
                             sentence(v) + "; the distance minus its error bound is below the limit"});
  for (const Reservation& r : result.reservations) {
    if (failing(r, strict)) suite.cases.push_back({r.kind, r.kind, reservationLine(r)});
    suite.output += r.kind + ": " + reservationLine(r) + "\n";
  }
  if (suite.cases.empty()) suite.cases.push_back({"min-distance", {}, {}});
  writeJunit(suite, file);
}

void writeHtmlReport(const CheckResult& result, const std::string& scene, double limit, bool strict,
                     const std::filesystem::path& file) {
  OutputFile out(file);
  auto& s = out.stream();
  s << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Abstand check</title>\n"
       "<style>body{font-family:sans-serif;max-width:60em;margin:2em auto}td,th{padding:.2em "
       ".8em;text-align:left;"
       "border-bottom:1px solid #ccc}.broken{color:#D55E00;font-weight:bold}</style></head><body>\n<h1>"
    << text::escapedXml(scene) << "</h1>\n<p class=\"" << (passed(result, strict) ? "" : "broken") << "\">"
    << (passed(result, strict) ? "Passed" : "Not passed") << ": smallest distance allowed "
    << formatDouble(limit) << " m, " << result.frames << " frames.</p>\n";
  table(s, "Limit violated", result.violations);
  reservationTable(s, result.reservations, strict);
  table(s, "Not proven: distance minus its error bound is below the limit", result.unproven);
  s << "<h2>Stale or rejected poses</h2>\n<p>";
  for (const auto& name : result.stale) s << text::escapedXml(name) << " ";
  if (result.stale.empty()) s << "None.";
  s << "</p>\n<p>An analysis tool, not a safety function.</p>\n</body></html>\n";
  out.commit();
}

}  // namespace abstand::run
