#include "ui/panels/lane_image.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/ui/fake_analysis.hpp"
#include "ui/style/heat.hpp"

namespace abstand::ui {
namespace lane_image_test {

constexpr double kRounding = 2e-8;  // s, more than columnFrames() allows for at 12 s

/// A made-up recording with gaps, of which the last third is not analysed yet.
struct LaneImageTest : ::testing::Test {
  LaneImageTest() {
    analysis.run(512);
    review.open(&analysis, session.outline(), std::vector<double>(session.outline().objects.size(), 0.15));
    review.pull();
  }
  static double clearance(std::size_t part, std::size_t frame) {
    if ((frame / 37 + part) % 11 == 0) return kNaN;
    return 0.3 + 0.29 * std::sin(0.05 * static_cast<double>(frame) * static_cast<double>(part + 1));
  }
  FakeSession session;
  FakeAnalysis analysis{session.outline(), clearance};
  RecordingReview review;
};

TEST_F(LaneImageTest, CoversEveryFrameOfEveryColumn) {
  const margin::ClearanceStore& store = *review.store();
  ASSERT_EQ(store.frames(), 512u);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 12.0);
  for (int n = 0; n < 60; ++n) {
    TimeRange shown{0.0, 12.0};
    if (n > 0) {
      const double a = uniform(random), b = uniform(random);
      const auto [low, high] = std::minmax(a, b);
      shown = {low, high + 0.1};
    }
    const int columns = 20 + static_cast<int>(random() % 900);
    const auto bounds = columnFrames(store, shown, columns);
    ASSERT_EQ(bounds.size(), static_cast<std::size_t>(columns) + 1);
    const std::size_t part = random() % store.layout().parts.size();
    const LaneRow row = laneRow(review, part, shown, bounds);
    const double width = shown.length() / columns;
    for (int x = 0; x < columns; ++x) {
      // All frames that are shown at some moment of the column; one right at an end may count or not.
      const double left = shown.from + x * width, right = left + width;
      bool row_fits = false;
      for (const int ends : {0, 1, 2, 3}) {
        const double from = left + (ends & 1 ? -kRounding : kRounding);
        const double to = right + (ends & 2 ? kRounding : -kRounding);
        double least = kInfinity;
        // Behind the last analysed frame nothing is known, although that frame is shown until the next one.
        bool unknown = to > analysis.t(store.frames() - 1);
        for (std::size_t i = 0; i < analysis.frames(); ++i) {
          if (analysis.t(i + 1) <= from || analysis.t(i) > to) continue;
          if (i >= 512 || std::isnan(analysis.clearance(part, i)))
            unknown = true;
          else
            least = std::min(least, static_cast<double>(static_cast<float>(analysis.clearance(part, i))));
        }
        const auto c = static_cast<std::size_t>(x);
        // What is not known is never shown as a distance.
        row_fits = row_fits || (row.unknown[c] == unknown && (unknown || row.colour[c] == heat(least)));
      }
      EXPECT_TRUE(row_fits) << "column " << x << " of " << columns;
    }
  }
}

TEST_F(LaneImageTest, MarksFramesInsideAndNear) {
  const TimeRange shown{0.0, 12.0};
  const int columns = 601;
  const auto bounds = columnFrames(*review.store(), shown, columns);
  for (std::size_t part = 0; part < 14; ++part) {
    const LaneRow row = laneRow(review, part, shown, bounds);
    std::size_t inside = 0, near = 0;
    for (const margin::ReviewEvent& event : review.review().events) {
      if (event.part != part) continue;
      const bool is_near = event.kind == margin::ReviewEvent::Kind::kNear;
      (is_near ? near : inside) += 1;
      const auto middle = static_cast<std::size_t>(0.5 * (event.t0 + event.t1) / 12.0 * columns);
      EXPECT_TRUE((is_near ? row.near : row.inside)[middle]);
    }
    EXPECT_EQ(inside > 0, std::count(row.inside.begin(), row.inside.end(), true) > 0);
    EXPECT_EQ(near > 0, std::count(row.near.begin(), row.near.end(), true) > 0);
  }
}

TEST_F(LaneImageTest, CombinedLaneShowsNearest) {
  const LaneRow all = wholeRow(review, {0.0, 12.0}, 601);
  EXPECT_TRUE(all.unknown.back()) << "not analysed";
  EXPECT_FALSE(all.unknown[300]);
  std::size_t inside = 0;
  for (std::size_t x = 0; x < all.inside.size(); ++x) inside += all.inside[x];
  EXPECT_GT(inside, 0u);
}

}  // namespace lane_image_test
}  // namespace abstand::ui
