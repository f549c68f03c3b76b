#include "app/run/junit.hpp"

#include <algorithm>

#include "core/base/output_file.hpp"
#include "core/text/escaped_xml.hpp"

namespace abstand::run {

void writeJunit(const JunitSuite& suite, const std::filesystem::path& file) {
  using text::escapedXml;
  const auto failures = std::count_if(suite.cases.begin(), suite.cases.end(),
                                      [](const JunitCase& c) { return !c.reason.empty(); });
  OutputFile out(file);
  auto& s = out.stream();
  s << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"" << escapedXml(suite.name)
    << "\" tests=\"" << suite.cases.size() << "\" failures=\"" << failures << "\">\n";
  for (const JunitCase& c : suite.cases) {
    s << "  <testcase classname=\"" << escapedXml(suite.class_name) << "\" name=\"" << escapedXml(c.name)
      << "\"";
    if (c.reason.empty()) {
      s << "/>\n";
      continue;
    }
    s << ">\n    <failure type=\"" << escapedXml(c.type) << "\" message=\"" << escapedXml(c.reason) << "\">"
      << escapedXml(c.reason) << "</failure>\n  </testcase>\n";
  }
  if (!suite.output.empty()) s << "  <system-out>" << escapedXml(suite.output) << "</system-out>\n";
  s << "</testsuite>\n";
  out.commit();
}

}  // namespace abstand::run
