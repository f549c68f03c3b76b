// The report: whole, escaped, and alone.
#include "app/report/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/report/svg_plot.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"

namespace abstand::report {
namespace report_test {

using ::testing::HasSubstr;
using ::testing::Not;

verify::CheckResult someResult() {
  verify::CheckResult r;
  r.name = "bound.mixed";
  r.what = "a < b & \"c\"";
  r.quantity = "part";
  r.reason = "why";
  r.poses = 7;
  r.worst = 2.0;
  r.p50 = 0.1;
  r.p99 = 0.5;
  r.limit = 1.0;
  r.breaches = 1;
  r.table = {{"h"}, {{"1 > 0"}}};
  r.plots.push_back({"errors", "x", "y", true, true, {{"s", {0.1, 1.0, 10.0}, {1.0, 0.0, 1e-3}}}});
  return r;
}

TEST(Report, IsSinglePageWithoutScriptsOrExternalResources) {
  const testing::ScratchFolder folder;
  const auto file = folder.path() / "v.html";
  writeReport({someResult()}, {}, "1.2.3", file);
  const std::string page = readFile(file, 1 << 22);
  EXPECT_THAT(page, HasSubstr("Abstand 1.2.3: verification"));
  EXPECT_THAT(page, HasSubstr("1 failed"));
  EXPECT_THAT(page, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
  EXPECT_THAT(page, HasSubstr("1 &gt; 0"));
  EXPECT_THAT(page, HasSubstr("prefers-color-scheme:dark"));
  for (const char* outside : {"http", "<script", "src=", "@import", "url("})
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  EXPECT_TRUE(page.ends_with("</body></html>\n"));
}

TEST(Report, PlotsHandleNonFiniteValues) {
  verify::Plot plot = someResult().plots[0];
  plot.series.push_back({"empty", {}, {}});
  plot.series.push_back({"bad", {kNaN, kInfinity, -1.0}, {1.0, 1.0, 1.0}});
  const std::string svg = svgPlot(plot);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  plot.series.clear();
  plot.log_x = plot.log_y = false;
  EXPECT_THAT(svgPlot(plot), Not(HasSubstr("nan")));
  // A flat line is drawn within the frame.
  plot.series.push_back({"flat", {1.0, 1.0}, {0.0, 0.0}});
  EXPECT_THAT(svgPlot(plot), Not(HasSubstr("nan")));
}

}  // namespace report_test
}  // namespace abstand::report
