// What belongs to the chair of a person who sits, and what to the person.
#include "tracking/tracker/chair_space.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/board_observation.hpp"
#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/small_camera.hpp"
#include "tests/tracking/tracker/upright_person.hpp"
#include "tracking/tracker/depth_fit.hpp"

namespace abstand::tracking {
namespace chair_space_test {

using enum humanmodel::Joint;

struct Chair : ::testing::Test, SeatedPerson {
  /// m from the axis of the trunk to the surface of the back.
  double back() const { return 0.5 * geometry::bounds(rig[RigSegment::kChest].shape).extent().x(); }
};

TEST_F(Chair, IsBehindTheBackAndUnderTheThighs) {
  const std::optional<ChairSpace> chair = ChairSpace::of(rig, X_WS);
  ASSERT_TRUE(chair);
  const Vector3d hips = jointAt(kPelvis), behind = -(back() + 0.05) * Vector3d::UnitX();
  EXPECT_TRUE(chair->holds(hips + behind + 0.3 * Vector3d::UnitZ())) << "back rest";
  EXPECT_TRUE(chair->holds(hips + behind + Vector3d(0.0, 0.2, 0.3)));
  EXPECT_TRUE(chair->holds({hips.x() + behind.x(), 0.0, 0.1})) << "its legs";
  EXPECT_TRUE(chair->holds(0.5 * (jointAt(kHipLeft) + jointAt(kKneeLeft)) - 0.08 * Vector3d::UnitZ()))
      << "seat";
}

TEST_F(Chair, IsNotWhereThePersonIs) {
  const std::optional<ChairSpace> chair = ChairSpace::of(rig, X_WS);
  ASSERT_TRUE(chair);
  for (const humanmodel::Joint joint :
       {kPelvis, kNeck, kHead, kHeadTop, kShoulderLeft, kElbowRight, kKneeLeft, kAnkleRight, kToeLeft})
    EXPECT_FALSE(chair->holds(jointAt(joint))) << humanmodel::jointName(joint);
  const Vector3d behind = -(back() + 0.05) * Vector3d::UnitX();
  EXPECT_FALSE(chair->holds(jointAt(kHead) + behind)) << "above the neck";
  EXPECT_FALSE(chair->holds(jointAt(kPelvis) + behind + Vector3d(0.0, 0.5, 0.3))) << "beside";
  EXPECT_FALSE(chair->holds(jointAt(kPelvis) + Vector3d(-0.8, 0.0, 0.3))) << "far behind";
}

TEST_F(Chair, LeansAsTheTrunkDoes) {
  RigPose pose = seatedPose(rig);
  const auto heldBehindTheNeck = [&] {
    place(rig, pose, X_WS);
    const std::optional<ChairSpace> chair = ChairSpace::of(rig, X_WS);
    const Vector3d p(jointAt(kPelvis).x() - back() - 0.05, 0.0, jointAt(kNeck).z() - 0.05);
    return chair && chair->holds(p);
  };
  EXPECT_TRUE(heldBehindTheNeck());
  pose.R_PS[index(RigSegment::kChest)] = Eigen::AngleAxisd(-0.4, Vector3d::UnitY());
  EXPECT_FALSE(heldBehindTheNeck()) << "the shoulders of somebody who leans back";
}

TEST_F(Chair, IsOnlyThatOfPeopleWhoSit) {
  EXPECT_FALSE(ChairSpace::of(rig, uprightAt(rig, Vector3d::Zero())));
  RigPose low = seatedPose(rig);
  low.X_WP.translation().z() = 0.34;
  place(rig, low, X_WS);
  EXPECT_FALSE(ChairSpace::of(rig, X_WS)) << "squats";
}

/// A board behind the back of a person who sits, from behind; nothing else is seen.
struct BoardBehind : Chair {
  DepthFit fit{rig};
  std::unique_ptr<BodyObservation> seen;

  BoardBehind() {
    const DepthCamera camera = smallCameraAt({-2.5, 0.0, 1.0}, {0.0, 0.0, 0.8});
    const Vector3d board_C = camera.X_WC.inverse() * Vector3d(jointAt(kPelvis).x() - back() - 0.10, 0.0, 0.6);
    seen = boardSeen(camera, static_cast<float>(board_C.z()), 5.0f,
                     [](int u, int v) { return std::abs(u - 80) < 12 && v > 55 && v < 90; });
  }
};

TEST_F(BoardBehind, CostsLessThanWhatNothingExplains) {
  ASSERT_GT(seen->points().count, 100u);
  std::vector<float> score(seen->points().count);
  fit.scores(seen->points(), X_WS, DepthFit::kAll, score.data());
  std::vector<float> capped = score;
  fit.lowerToChair(seen->points(), X_WS, capped.data());
  std::size_t lower = 0;
  for (std::size_t i = 0; i < score.size(); ++i) {
    EXPECT_LE(capped[i], score[i]);
    lower += capped[i] < score[i];
    if (capped[i] < score[i]) {
      EXPECT_EQ(capped[i], kChairMisfit);
    }
  }
  EXPECT_GT(lower, score.size() / 2);
  const DepthMisfit sits = fit.misfit(*seen, X_WS);
  // The same person on the toes: the board is that of no chair.
  RigPose low = seatedPose(rig);
  low.X_WP.translation().z() = 0.34;
  RigPlacement X_WT;
  place(rig, low, X_WT);
  EXPECT_LT(sits.cost, 0.5 * fit.misfit(*seen, X_WT).cost);
}

TEST_F(BoardBehind, AttractsNoSegment) {
  DepthFit::Weights weights;
  weights.prior.setConstant(1e-3);
  RigPose pose = seatedPose(rig);
  const Vector3d hips = pose.X_WP.translation();
  testing::NoAlloc guard;
  fit.refine(*seen, pose, weights, 3, pose);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_LT((pose.X_WP.translation() - hips).head<2>().norm(), 0.02) << "m";
}

}  // namespace chair_space_test
}  // namespace abstand::tracking
