// Reach of two bodies that face opposite ways.
#include "tracking/tracker/other_facing.hpp"

#include <gtest/gtest.h>

#include "humanmodel/joint_covariance.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/upright_person.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace other_facing_test {

using enum humanmodel::Joint;

struct OtherFacing : ::testing::Test {
  /// Upright at `x` (m), with the front at `yaw` (rad).
  TrackedBody bodyAt(double x, double yaw) const {
    TrackedBody body;
    body.found = true;
    body.pose.X_WP.translation() = Vector3d(x, 0.0, 0.95);
    body.pose.X_WP.linear() = Eigen::AngleAxisd(yaw, Vector3d::UnitZ()).toRotationMatrix();
    place(rig, body.pose, body.X_WS);
    jointsOf(rig, body.X_WS, humanmodel::JointState::kTracked, body.frame);
    return body;
  }
  /// m, reach of a joint of `body` towards a place.
  static double reach(const TrackedBody& body, humanmodel::Joint joint, const Vector3d& place) {
    return humanmodel::radiusToward(humanmodel::covarianceOf(body.frame, joint),
                                    (place - body.frame[joint]).normalized());
  }
  static constexpr double kRounding = 1e-9;  // m

  BodyRig rig = makeRig(humanmodel::makeHuman({}));
};

TEST_F(OtherFacing, ReachContainsTheJointsOfTheOtherBody) {
  const TrackedBody other = bodyAt(0.1, kPi);
  TrackedBody body = bodyAt(0.0, 0.0);
  testing::NoAlloc guard;
  encloseOtherFacing(other, body);
  for (const humanmodel::Joint joint : {kPelvis, kHeadTop, kHandLeft, kToeRight}) {
    const Vector3d& there = other.frame[joint];
    EXPECT_GE(reach(body, joint, there), (there - body.frame[joint]).norm() - kRounding);
  }
}

// Without another body, or if that has turned, too, the sides may be exchanged.
TEST_F(OtherFacing, ReachContainsTheFlippedBody) {
  TrackedBody lost = bodyAt(0.0, kPi);
  lost.found = false;
  for (const TrackedBody& other : {lost, bodyAt(0.0, 0.9)}) {
    TrackedBody body = bodyAt(0.0, 0.0);
    const Vector3d right = body.frame[kHandRight];
    encloseOtherFacing(other, body);
    EXPECT_GE(reach(body, kHandLeft, right), (right - body.frame[kHandLeft]).norm() - kRounding);
  }
}

TEST_F(OtherFacing, LostBodyHasNoReach) {
  TrackedBody lost;
  encloseOtherFacing(bodyAt(0.0, kPi), lost);
  EXPECT_FALSE(lost.frame.has(kPelvis));
}

TEST_F(OtherFacing, PosesFaceAlikeUpToSixtyDegrees) {
  const RigPose ahead = bodyAt(0.0, 0.0).pose;
  for (const double yaw : {0.0, 1.0, -1.0}) EXPECT_TRUE(faceAlike(ahead, bodyAt(0.0, yaw).pose)) << yaw;
  for (const double yaw : {1.1, kPi, -1.1}) EXPECT_FALSE(faceAlike(ahead, bodyAt(0.0, yaw).pose)) << yaw;
}

}  // namespace other_facing_test
}  // namespace abstand::tracking
