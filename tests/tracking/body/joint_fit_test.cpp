// Poses found again from their joints.
#include "tracking/body/joint_fit.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/body/random_rig_pose.hpp"

namespace abstand::tracking {
namespace joint_fit_test {

using testing::randomRigPose;

humanmodel::SkeletonFrame joints(const BodyRig& rig, const RigPose& pose) {
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  humanmodel::SkeletonFrame frame;
  jointsOf(rig, X_WS, humanmodel::JointState::kTracked, frame);
  return frame;
}

TEST(JointFit, RecoversPoses) {
  constexpr double kExact = 1e-4;  // m; the last of it comes slowly where a wish lies at a limit
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    const humanmodel::SkeletonFrame frame = joints(rig, randomRigPose(rig, seed, 0.9));
    const JointFit fit = fitJoints(rig, frame, startAt(frame));
    EXPECT_LT(fit.rms, kExact);
  }
}

TEST(JointFit, OtherBoneLengthsAreFittedWithinReach) {
  humanmodel::HumanOptions tall;
  tall.height = 1.85;
  const BodyRig rig = makeRig(humanmodel::makeHuman({})), other = makeRig(humanmodel::makeHuman(tall));
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const humanmodel::SkeletonFrame frame = joints(other, randomRigPose(other, seed, 0.7));
    const JointFit fit = fitJoints(rig, frame, startAt(frame));
    EXPECT_GT(fit.rms, 0.005);
    EXPECT_LT(fit.rms, 0.10 * 0.5);  // a tenth of a metre taller, shared between both ends
  }
}

TEST(JointFit, MissingJointsDoNotAffectOthers) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  const RigPose truth = randomRigPose(rig, 11, 0.6);
  humanmodel::SkeletonFrame frame = joints(rig, truth);
  for (const humanmodel::Joint j : {humanmodel::Joint::kHandLeft, humanmodel::Joint::kToeRight,
                                    humanmodel::Joint::kHeadTop, humanmodel::Joint::kSpine})
    frame.set(j, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
  const JointFit fit = fitJoints(rig, frame, startAt(frame));
  EXPECT_LT(fit.rms, 1e-4);
  EXPECT_EQ(fitJoints(rig, humanmodel::SkeletonFrame{}, RigPose{}).rms, kInfinity);
}

}  // namespace joint_fit_test
}  // namespace abstand::tracking
