#include "app/run/check_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::run {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
        out += c;
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

std::string metres(double value) { return formatDouble(value) + " m"; }

std::string sentence(const Violation& v) {
  std::string text = v.a + " to " + v.b + ": " + metres(v.min_distance) + ", limit " + metres(v.limit);
  if (std::isinf(v.uncertainty))
    text += ", and one of them was not seen at all";
  else if (v.uncertainty > 0.0)
    text += " widened by " + metres(v.uncertainty) + " for what is not known of their places";
  text += ", from " + formatDouble(v.start) + " s to " + formatDouble(v.end) + " s";
  return v.recording.empty() ? text : text + ", " + v.recording;
}

std::string reservationLine(const Reservation& r) {
  return r.recording.empty() ? r.text : r.text + ", " + r.recording;
}

/// A failed test case.
struct Failure {
  std::string name, type, reason;
};

void reservationTable(std::ostream& out, const std::vector<Reservation>& rows, bool strict) {
  out << "<h2>Reservations</h2>\n";
  if (rows.empty()) {
    out << "<p>None.</p>\n";
    return;
  }
  out << "<table><tr><th>kind</th><th>what is not known</th><th>recording</th></tr>\n";
  for (const Reservation& r : rows)
    out << "<tr><td" << (failing(r, strict) ? " class=\"broken\"" : "") << ">" << escaped(r.kind)
        << "</td><td>" << escaped(r.text) << "</td><td>" << escaped(r.recording) << "</td></tr>\n";
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
    out << "<tr><td>" << escaped(v.a) << "</td><td>" << escaped(v.b) << "</td><td>" << formatDouble(v.start)
        << "</td><td>" << formatDouble(v.end) << "</td><td>" << formatDouble(v.min_distance) << "</td><td>"
        << formatDouble(v.limit) << "</td><td>" << escaped(v.recording) << "</td></tr>\n";
  out << "</table>\n";
}

}  // namespace

void writeJunit(const CheckResult& result, const std::string& scene, bool strict,
                const std::filesystem::path& file) {
  std::vector<Failure> failures;
  for (const Violation& v : result.violations)
    failures.push_back({v.a + " to " + v.b, "distance", sentence(v)});
  if (strict)
    for (const Violation& v : result.unproven)
      failures.push_back({v.a + " to " + v.b, "not_proven",
                          sentence(v) + "; the distance minus its error bound is below the limit"});
  std::string all;
  for (const Reservation& r : result.reservations) {
    if (failing(r, strict)) failures.push_back({r.kind, r.kind, reservationLine(r)});
    all += r.kind + ": " + reservationLine(r) + "\n";
  }
  OutputFile out(file);
  auto& s = out.stream();
  s << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"abstand check " << escaped(scene)
    << "\" tests=\"" << std::max<std::size_t>(failures.size(), 1) << "\" failures=\"" << failures.size()
    << "\">\n";
  if (failures.empty()) s << "  <testcase classname=\"" << escaped(scene) << "\" name=\"min-distance\"/>\n";
  for (const Failure& f : failures)
    s << "  <testcase classname=\"" << escaped(scene) << "\" name=\"" << escaped(f.name)
      << "\">\n    <failure type=\"" << escaped(f.type) << "\" message=\"" << escaped(f.reason) << "\">"
      << escaped(f.reason) << "</failure>\n  </testcase>\n";
  if (!all.empty()) s << "  <system-out>" << escaped(all) << "</system-out>\n";
  s << "</testsuite>\n";
  out.commit();
}

void writeHtmlReport(const CheckResult& result, const std::string& scene, double limit, bool strict,
                     const std::filesystem::path& file) {
  OutputFile out(file);
  auto& s = out.stream();
  s << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Abstand check</title>\n"
       "<style>body{font-family:sans-serif;max-width:60em;margin:2em auto}td,th{padding:.2em "
       ".8em;text-align:left;"
       "border-bottom:1px solid #ccc}.broken{color:#D55E00;font-weight:bold}</style></head><body>\n<h1>"
    << escaped(scene) << "</h1>\n<p class=\"" << (passed(result, strict) ? "" : "broken") << "\">"
    << (passed(result, strict) ? "Passed" : "Not passed") << ": smallest distance allowed "
    << formatDouble(limit) << " m, " << result.frames << " frames.</p>\n";
  table(s, "Limit broken", result.violations);
  reservationTable(s, result.reservations, strict);
  table(s, "Not proven: distance minus its error bound is below the limit", result.unproven);
  s << "<h2>Stale or refused poses</h2>\n<p>";
  for (const auto& name : result.stale) s << escaped(name) << " ";
  if (result.stale.empty()) s << "None.";
  s << "</p>\n<p>An analysis tool, not a safety function.</p>\n</body></html>\n";
  out.commit();
}

}  // namespace abstand::run
