// Hidden joints: no pose of the hidden limb is outside what is stated, and it grows to that with time.
#include "tracking/tracker/hidden_spread.hpp"

#include <gtest/gtest.h>

#include "humanmodel/joint_covariance.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/tracking/body/random_rig_pose.hpp"

namespace abstand::tracking {
namespace hidden_spread_test {

constexpr double kRounding = 1e-9;  // m

const BodyRig& rig() {
  static const BodyRig made = makeRig(humanmodel::makeHuman({}));
  return made;
}

HiddenSpread::Extents anySpace() {
  HiddenSpread::Extents extent;
  extent.fill(kInfinity);
  return extent;
}
JointCovariances noShape() {
  JointCovariances shape;
  shape.fill(Matrix3d::Zero());
  return shape;
}

SeenSegments without(std::initializer_list<RigSegment> hidden) {
  SeenSegments seen = (1u << kRigSegments) - 1u;
  for (const RigSegment s : hidden) seen &= ~(1u << index(s));
  return seen;
}

/// Where the joints are when a seen segment is held in place and everything else is in `pose`.
humanmodel::SkeletonFrame heldBy(RigSegment held, const RigPlacement& held_at, const RigPose& pose) {
  RigPlacement X_WS;
  place(rig(), pose, X_WS);
  const Transform X = held_at[index(held)] * X_WS[index(held)].inverse();
  for (Transform& X_WP : X_WS) X_WP = X * X_WP;
  humanmodel::SkeletonFrame frame;
  jointsOf(rig(), X_WS, humanmodel::JointState::kTracked, frame);
  return frame;
}

TEST(HiddenPathLengths, AreZeroIfSeenAndInfiniteIfNothingIsSeen) {
  for (const double length : hiddenPathLengths(rig(), without({}))) EXPECT_EQ(length, 0.0);
  for (const double length : hiddenPathLengths(rig(), 0)) EXPECT_EQ(length, kInfinity);
}

TEST(HiddenPathLengths, AddBonesFromLastSeenSegment) {
  using enum humanmodel::Joint;
  const auto lengths = hiddenPathLengths(
      rig(), without({RigSegment::kForearmLeft, RigSegment::kHandLeft, RigSegment::kCalfRight}));
  const auto lengthOf = [&](humanmodel::Joint j) { return lengths[static_cast<std::size_t>(j)]; };
  const double forearm = rig().p_joint[static_cast<std::size_t>(kWristLeft)].norm();
  const double hand = rig().p_joint[static_cast<std::size_t>(kHandLeft)].norm();
  EXPECT_EQ(lengthOf(kElbowLeft), 0.0);
  EXPECT_NEAR(lengthOf(kWristLeft), forearm, kRounding);
  EXPECT_NEAR(lengthOf(kHandLeft), forearm + hand, kRounding);
  EXPECT_GT(forearm, 0.2);
  // The foot is seen: the ankle is where it ends.
  EXPECT_NEAR(lengthOf(kAnkleRight), 0.0, kRounding);
  EXPECT_EQ(lengthOf(kToeRight), 0.0);
  EXPECT_EQ(lengthOf(kWristRight), 0.0);
}

TEST(HiddenPathLengths, BoundPosesOfHiddenLimb) {
  struct Case {
    RigSegment held;
    SeenSegments seen;
  };
  using enum RigSegment;
  const std::vector<Case> cases{
      {kChest, without({kUpperArmLeft, kForearmLeft, kHandLeft})},
      {kUpperArmRight, without({kForearmRight, kHandRight})},
      {kPelvis, without({kThighLeft, kThighRight, kCalfLeft, kCalfRight, kFootLeft, kFootRight})},
      {kForearmLeft, 1u << index(kForearmLeft)},
      {kHead, 1u << index(kHead)}};
  for (const Case& c : cases) {
    const auto lengths = hiddenPathLengths(rig(), c.seen);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      RigPlacement held_at;
      place(rig(), testing::randomRigPose(rig(), 2 * seed, 1.0), held_at);
      const humanmodel::SkeletonFrame a =
          heldBy(c.held, held_at, testing::randomRigPose(rig(), 2 * seed, 1.0));
      const humanmodel::SkeletonFrame b =
          heldBy(c.held, held_at, testing::randomRigPose(rig(), 2 * seed + 1, 1.0));
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
        if ((c.seen >> index(rig().carrier[j]) & 1u) != 0) continue;
        // Of joints that hang on another seen segment, which moved with the pose, nothing is claimed here.
        if (c.held != kHead && c.held != kForearmLeft && lengths[j] == 0.0) continue;
        EXPECT_LE((a.p[j] - b.p[j]).norm(), 2.0 * lengths[j] + kRounding)
            << humanmodel::jointName(static_cast<humanmodel::Joint>(j));
      }
    }
  }
}

TEST(HiddenSpread, GrowsFromMinToSpaceOfLimb) {
  using enum RigSegment;
  HiddenSpread hidden(rig());
  const auto wrist = static_cast<std::size_t>(humanmodel::Joint::kWristLeft),
             elbow = static_cast<std::size_t>(humanmodel::Joint::kElbowLeft),
             head = static_cast<std::size_t>(humanmodel::Joint::kHead);
  hidden.see(0.0, without({}), anySpace(), noShape());
  for (const double s : hidden.spread()) EXPECT_EQ(s, 0.0);
  const SeenSegments seen = without({kUpperArmLeft, kForearmLeft, kHandLeft});
  const double space = 2.0 * hiddenPathLengths(rig(), seen)[wrist];
  double last = 0.0;
  for (int i = 1; i <= 60; ++i) {
    const double t = i / 30.0;
    hidden.see(t, seen, anySpace(), noShape());
    const double reach = humanmodel::partUncertainty(0.0, hidden.spread()[wrist]);
    EXPECT_GE(reach + kRounding, HiddenSpread::kMin);
    EXPECT_GE(humanmodel::partUncertainty(0.0, hidden.spread()[elbow]) + kRounding, HiddenSpread::kMin);
    EXPECT_GE(reach, last);
    EXPECT_GE(reach + kRounding, std::min(space, humanmodel::kPersonSpeed * t))
        << "somebody is faster than that";
    EXPECT_LE(reach, space + kRounding) << "an arm is not longer";
    EXPECT_EQ(hidden.spread()[head], 0.0);
    last = reach;
  }
  EXPECT_NEAR(last, space, kRounding);
  hidden.see(2.1, without({}), anySpace(), noShape());
  EXPECT_EQ(hidden.spread()[wrist], 0.0);
}

TEST(HiddenSpread, IsMaxForLimbNeverSeen) {
  HiddenSpread hidden(rig());
  const SeenSegments seen = without({RigSegment::kThighLeft, RigSegment::kCalfLeft, RigSegment::kFootLeft});
  const HiddenSpread::Extents any = anySpace();
  const JointCovariances none = noShape();
  testing::NoAlloc guard;
  hidden.see(0.0, seen, any, none);
  EXPECT_EQ(guard.count(), 0);
  const auto ankle = static_cast<std::size_t>(humanmodel::Joint::kAnkleLeft);
  EXPECT_NEAR(humanmodel::partUncertainty(0.0, hidden.spread()[ankle]),
              2.0 * hiddenPathLengths(rig(), seen)[ankle], kRounding);
}

TEST(HiddenSpread, HasTheShapeOfTheFreeSpaceWhereThatIsTheSmallestBound) {
  HiddenSpread hidden(rig());
  const auto ankle = static_cast<std::size_t>(humanmodel::Joint::kAnkleLeft);
  const SeenSegments seen = without({RigSegment::kCalfLeft, RigSegment::kFootLeft});
  HiddenSpread::Extents extent = anySpace();
  JointCovariances shape = noShape();
  shape[ankle] = Vector3d(0.16, 0.04, 0.09).asDiagonal();
  const auto semiAxis = [&](const Vector3d& d) {
    return humanmodel::reachAlong(hidden.covariance()[ankle], d);
  };
  extent[ankle] = 0.3;
  hidden.see(0.0, seen, extent, shape);
  EXPECT_NEAR(semiAxis(Vector3d::UnitX()), 0.4, kRounding);
  EXPECT_NEAR(semiAxis(Vector3d::UnitY()), 0.2, kRounding);
  // Bones: nowhere farther than twice their length, which is less than the extent.
  extent[ankle] = 10.0;
  hidden.see(0.1, seen, extent, shape);
  EXPECT_NEAR(semiAxis(Vector3d::UnitY()), 2.0 * hiddenPathLengths(rig(), seen)[ankle], kRounding);
  // Little of the segment was seen when it was seen last.
  extent[ankle] = 0.1;
  hidden.see(0.2, seen, extent, shape);
  EXPECT_NEAR(semiAxis(Vector3d::UnitY()), HiddenSpread::kMin, kRounding);
  hidden.see(0.3, without({}), extent, shape);
  EXPECT_TRUE(hidden.covariance()[ankle].isZero(0.0));
}

TEST(HiddenSpread, IsNoLargerThanTheFreeSpace) {
  HiddenSpread hidden(rig());
  const auto ankle = static_cast<std::size_t>(humanmodel::Joint::kAnkleLeft);
  HiddenSpread::Extents extent = anySpace();
  extent[ankle] = 0.3;
  hidden.see(0.0, without({RigSegment::kCalfLeft, RigSegment::kFootLeft}), extent, noShape());
  EXPECT_NEAR(humanmodel::partUncertainty(0.0, hidden.spread()[ankle]), 0.3, kRounding);
  extent[ankle] = 0.0;
  hidden.see(1.0, without({RigSegment::kCalfLeft, RigSegment::kFootLeft}), extent, noShape());
  EXPECT_NEAR(humanmodel::partUncertainty(0.0, hidden.spread()[ankle]), HiddenSpread::kMin, kRounding);
}

}  // namespace hidden_spread_test
}  // namespace abstand::tracking
