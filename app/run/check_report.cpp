#include "app/run/check_report.hpp"

#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand {
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
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

std::string sentence(const Violation& v) {
  return v.a + " to " + v.b + ": " + formatDouble(v.min_distance) + " m, limit " + formatDouble(v.limit) +
         " m, from " + formatDouble(v.start) + " s to " + formatDouble(v.end) + " s";
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

void writeJunit(const CheckResult& result, const std::string& scene, const std::filesystem::path& file) {
  OutputFile out(file);
  auto& s = out.stream();
  const std::size_t cases = std::max<std::size_t>(result.violations.size(), 1);
  s << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"abstand check " << escaped(scene)
    << "\" tests=\"" << cases << "\" failures=\"" << result.violations.size() << "\">\n";
  if (result.violations.empty())
    s << "  <testcase classname=\"" << escaped(scene) << "\" name=\"min-distance\"/>\n";
  for (const Violation& v : result.violations)
    s << "  <testcase classname=\"" << escaped(scene) << "\" name=\"" << escaped(v.a + " to " + v.b)
      << "\">\n    <failure message=\"" << escaped(sentence(v)) << "\"/>\n  </testcase>\n";
  s << "</testsuite>\n";
  out.commit();
}

void writeHtmlReport(const CheckResult& result, const std::string& scene, double limit,
                     const std::filesystem::path& file) {
  OutputFile out(file);
  auto& s = out.stream();
  s << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Abstand check</title>\n"
       "<style>body{font-family:sans-serif;max-width:60em;margin:2em auto}td,th{padding:.2em "
       ".8em;text-align:left;"
       "border-bottom:1px solid #ccc}.broken{color:#D55E00;font-weight:bold}</style></head><body>\n<h1>"
    << escaped(scene) << "</h1>\n<p class=\"" << (result.violations.empty() ? "" : "broken") << "\">"
    << (result.violations.empty() ? "Passed" : "Not passed") << ": smallest distance allowed "
    << formatDouble(limit) << " m, " << result.frames << " frames.</p>\n";
  table(s, "Limit broken", result.violations);
  table(s, "Not proven: distance minus its error bound is below the limit", result.unproven);
  s << "<h2>Stale or refused poses</h2>\n<p>";
  for (const auto& name : result.stale) s << escaped(name) << " ";
  if (result.stale.empty()) s << "None.";
  s << "</p>\n<p>An analysis tool, not a safety function.</p>\n</body></html>\n";
  out.commit();
}

}  // namespace abstand
