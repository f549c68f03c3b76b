// Segments need to be visible, and limbs to explain something that nothing else explains.
#include "tracking/tracker/seen_segments.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/tracking/tracker/board_observation.hpp"
#include "tests/tracking/tracker/small_camera.hpp"
#include "tests/tracking/tracker/upright_person.hpp"
#include "tracking/tracker/depth_fit.hpp"

namespace abstand::tracking {
namespace seen_segments_test {

using enum RigSegment;

constexpr SeenSegments kAll = (1u << kRigSegments) - 1u;

struct SegmentsSeen : ::testing::Test {
  std::array<double, kRigSegments> visible, support;

  SegmentsSeen() {
    visible.fill(1.0);
    support.fill(10.0);
  }
  static SeenSegments without(std::initializer_list<RigSegment> segments) {
    SeenSegments seen = kAll;
    for (const RigSegment s : segments) seen &= ~(1u << index(s));
    return seen;
  }
};

TEST_F(SegmentsSeen, OfAVisibleBodyAreAll) { EXPECT_EQ(seenSegments(visible, support), kAll); }

TEST_F(SegmentsSeen, OfACoveredForearmAreTheOthers) {
  visible[index(kForearmLeft)] = 0.9 * kSeenShare;
  EXPECT_EQ(seenSegments(visible, support), without({kForearmLeft})) << "a hand may show beside a box";
}

TEST_F(SegmentsSeen, LackAHandThatExplainsNothing) {
  support[index(kHandRight)] = 0.0;
  EXPECT_EQ(seenSegments(visible, support), without({kHandRight}));
}

TEST_F(SegmentsSeen, EndWhereTheSupportOfAnArmEnds) {
  support[index(kUpperArmLeft)] = 0.0;
  support[index(kForearmRight)] = 0.0;
  EXPECT_EQ(seenSegments(visible, support),
            without({kUpperArmLeft, kForearmLeft, kHandLeft, kForearmRight, kHandRight}));
}

TEST_F(SegmentsSeen, IncludeAFootBelowAHiddenThigh) {
  support[index(kThighLeft)] = 0.0;
  EXPECT_EQ(seenSegments(visible, support), without({kThighLeft}));
}

TEST_F(SegmentsSeen, IncludeTheTrunkWithoutSupport) {
  for (const RigSegment s : {kPelvis, kChest, kHead}) support[index(s)] = 0.0;
  EXPECT_EQ(seenSegments(visible, support), kAll);
}

TEST(Support, IsTheCostThatTheOtherSegmentsAdd) {
  constexpr double kRounding = 1e-3;       // points; sums of float
  constexpr double kUnexplained = 6.4e-3;  // m^2, cost of a point that nothing explains
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  const RigPlacement X_WS = uprightAt(rig, Vector3d::Zero());
  const auto seen = boardSeen(smallCamera(), 2.4f, 4.0f, [](int u, int) { return std::abs(u - 80) < 25; });
  const DepthFit fit(rig);
  std::array<double, kRigSegments> support;
  fit.support(*seen, X_WS, support);

  const SeenPoints& points = seen->points();
  std::vector<float> score(points.count);
  const auto costOf = [&](std::uint32_t segments) {
    fit.scores(points, X_WS, segments, score.data());
    return DepthFit::robustMean(score.data(), points.count) * static_cast<double>(points.count);
  };
  const double whole = costOf(DepthFit::kAll);
  double largest = 0.0;
  for (std::size_t s = 0; s < kRigSegments; ++s) {
    EXPECT_NEAR(support[s], (costOf(DepthFit::kAll & ~(1u << s)) - whole) / kUnexplained, kRounding)
        << segmentName(segmentAt(s));
    largest = std::max(largest, support[s]);
  }
  EXPECT_GT(largest, 10.0);
}

}  // namespace seen_segments_test
}  // namespace abstand::tracking
