// Which postures may explain how high a person is.
#include "tracking/tracker/other_posture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abstand::tracking {
namespace other_posture_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using enum OtherPosture::Kind;

std::vector<OtherPosture::Kind> kindsOf(double seen, bool known) {
  Stature stature;
  stature.seen = seen;
  if (known) stature.source = Stature::Source::kMeasured;
  std::vector<OtherPosture::Kind> kinds;
  for (const OtherPosture& other : otherPostures(stature)) kinds.push_back(other.kind);
  return kinds;
}

TEST(OtherPosture, DependsOnTheSeenHeight) {
  EXPECT_THAT(kindsOf(1.50, true), ElementsAre(kSeated, kKneeling, kLowered, kRaisedArms));
  EXPECT_THAT(kindsOf(1.70, true), ElementsAre(kLowered, kRaisedArms));
  EXPECT_THAT(kindsOf(1.95, true), ElementsAre(kRaisedArms)) << "nobody who stoops is so high";
  EXPECT_THAT(kindsOf(1.30, false), ElementsAre(kChild));
  EXPECT_THAT(kindsOf(0.80, false), IsEmpty());
  EXPECT_THAT(kindsOf(2.30, false), IsEmpty());
}

TEST(OtherPosture, StaturesAreThoseOfTheShares) {
  Stature stature;
  stature.seen = 1.48;
  stature.source = Stature::Source::kMeasured;
  const auto others = otherPostures(stature);
  EXPECT_NEAR(others[0].stature.used, 1.48 / Stature::kSeatedShare, 1e-12);
  EXPECT_NEAR(others[1].stature.used, 1.48 / Stature::kKneelingShare, 1e-12);
  EXPECT_NEAR(others[2].stature.used, 1.48 + Stature::kLowered, 1e-12);
  EXPECT_NEAR(others[3].stature.used, 1.48 - Stature::kAboveHead, 1e-12);
  for (const OtherPosture& other : others) {
    EXPECT_FALSE(other.stature.known());
    EXPECT_EQ(other.stature.seen, 1.48);
    EXPECT_LE(other.stature.interval[0], other.stature.used);
    EXPECT_GE(other.stature.interval[1], other.stature.used);
  }
}

/// A body of the rig's stature that stands; `lower` (m): the head is lower by that.
humanmodel::SkeletonFrame standing(const BodyRig& rig, double lower, double hands) {
  using enum humanmodel::Joint;
  humanmodel::SkeletonFrame frame;
  for (Vector3d& p : frame.p) p = Vector3d(0.0, 0.0, 0.5 * rig.height);
  frame.p[static_cast<std::size_t>(kHeadTop)].z() = rig.height - lower;
  for (const humanmodel::Joint j : {kAnkleLeft, kAnkleRight, kToeLeft, kToeRight})
    frame.p[static_cast<std::size_t>(j)].z() = 0.0;
  for (const humanmodel::Joint j : {kHandLeft, kWristRight}) frame.p[static_cast<std::size_t>(j)].z() = hands;
  return frame;
}

TEST(OtherPosture, AgreesWithTheFittedBody) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  const auto upright = standing(rig, 0.0, 0.8), stooped = standing(rig, 0.1, 0.8),
             raised = standing(rig, 0.0, rig.height + 0.2);
  EXPECT_TRUE(standsUpright(upright, rig));
  EXPECT_FALSE(standsUpright(stooped, rig));
  EXPECT_FALSE(standsUpright(raised, rig));
  EXPECT_TRUE(isIn(kChild, upright, rig));
  EXPECT_FALSE(isIn(kChild, stooped, rig));
  EXPECT_TRUE(isIn(kRaisedArms, raised, rig));
  EXPECT_FALSE(isIn(kRaisedArms, upright, rig));
  EXPECT_TRUE(isIn(kSeated, stooped, rig));
}

}  // namespace other_posture_test
}  // namespace abstand::tracking
