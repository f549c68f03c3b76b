// Limbs that reach for points.
#include "tracking/tracker/limb_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/support/random_pose.hpp"
#include "tests/tracking/tracker/board_observation.hpp"
#include "tests/tracking/tracker/small_camera.hpp"

namespace abstand::tracking {
namespace limb_search_test {

TEST(ReachFor, ReachesEveryGoalInRange) {
  const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    for (const Limb& limb : kLimbs) {
      RigPose pose;
      pose.X_WP = testing::randomPose(seed, 1.0);
      RigPlacement X_WS;
      place(rig, pose, X_WS);
      const Vector3d root = X_WS[index(limb.upper)].translation();
      const double a = rig[limb.lower].p_parent.norm(), b = rig[limb.end].p_parent.norm();
      const Vector3d goal = root + testing::randomPose(seed + 500, 0.5).translation();
      const double away = (goal - root).norm();
      reachFor(rig, limb, X_WS, goal, 0.01 * static_cast<double>(seed) - 1.0, pose);
      place(rig, pose, X_WS);
      const double miss = (X_WS[index(limb.end)].translation() - goal).norm();
      // The bend ends where the hinge does: 155 degrees.
      const double folded = std::sqrt(a * a + b * b + 2.0 * a * b * std::cos(rig[limb.lower].upper[0]));
      if (away < a + b - 2e-3 && away > folded + 0.02) {
        ++tried;
        EXPECT_LT(miss, 1e-6) << segmentName(limb.upper) << " seed " << seed;
      } else if (away >= a + b) {
        EXPECT_NEAR(miss, away - (a + b), 2e-3);  // stretched out as far as the law of cosines is kept safe
      }
      EXPECT_GE(pose.angle[index(limb.lower)][0], rig[limb.lower].lower[0]);
      EXPECT_LE(pose.angle[index(limb.lower)][0], rig[limb.lower].upper[0]);
    }
  }
  EXPECT_GT(tried, 200);
}

/// A board with an arm to the left, and a body in front of it whose arms hang.
struct SearchedLimbs : ::testing::Test {
  BodyRig rig = makeRig(humanmodel::makeHuman({}));
  DepthFit fit{rig};
  std::unique_ptr<LimbSearch> limbs = std::make_unique<LimbSearch>(fit);
  std::unique_ptr<BodyObservation> seen = boardSeen(smallCamera(), 2.4f, 4.0f, [](int u, int v) {
    const bool trunk = std::abs(u - 80) < 12, arm = u >= 80 && u < 115 && std::abs(v - 35) < 4;
    return trunk || arm;
  });
  RigPose start;

  SearchedLimbs() { start.X_WP.translation() = Vector3d(0.0, 0.0, 0.95); }
  /// The pose that a search for a limb ends with.
  RigPose found(std::size_t limb, double kept) {
    std::mt19937_64 random(7);
    RigPose pose = start;
    EXPECT_TRUE(limbs->search(*seen, limb, {100, 0.3, kept}, random, pose));
    return pose;
  }
};

TEST_F(SearchedLimbs, EndAtTheSamePlaceHoweverManyCostsAreExact) {
  constexpr double kAll = 1e9;
  for (const std::size_t limb : {0u, 2u}) {
    const RigPose exact = found(limb, kAll);
    const std::vector<LimbTry> all(limbs->tries(limb).begin(), limbs->tries(limb).end());
    const double smallest =
        std::min_element(all.begin(), all.end(), [](auto& a, auto& b) { return a.cost < b.cost; })->cost;
    for (const double kept : {1.0, 1.1}) {
      const RigPose pose = found(limb, kept);
      EXPECT_EQ(BodySolver::Vector(difference(rig, exact, pose)).norm(), 0.0);
      const std::span<const LimbTry> tries = limbs->tries(limb);
      ASSERT_EQ(tries.size(), all.size());
      int bounds = 0;
      for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_LE(tries[i].cost, all[i].cost);
        EXPECT_EQ(tries[i].end, all[i].end);
        if (all[i].cost <= kept * smallest) {
          EXPECT_EQ(tries[i].cost, all[i].cost);
        }
        EXPECT_TRUE(tries[i].cost == all[i].cost || tries[i].cost > kept * smallest);
        bounds += tries[i].cost < all[i].cost;
      }
      EXPECT_GT(bounds, 5) << "positions that were not scored to the end, " << limb << " " << kept;
    }
  }
}

// Where an arm may be that explains nothing: it hangs, or the trunk hides it.
TEST_F(SearchedLimbs, TryArmsThatHangOrPointAwayFromTheCamera) {
  constexpr double kStretched = 2e-3;  // m; a straight arm is not quite
  RigPlacement X_WS;
  place(rig, start, X_WS);
  for (const std::size_t limb : {0u, 1u}) {
    found(limb, 1.1);
    const Vector3d shoulder = X_WS[index(kLimbs[limb].upper)].translation();
    const Vector3d away = (shoulder - seen->views()[0].eye()).normalized();
    const double length = lengthOf(rig, kLimbs[limb]);
    for (const Vector3d& direction : {Vector3d(-Vector3d::UnitZ()), away}) {
      const std::span<const LimbTry> tries = limbs->tries(limb);
      EXPECT_TRUE(std::any_of(tries.begin(), tries.end(),
                              [&](const LimbTry& one) {
                                return (one.end - (shoulder + length * direction)).norm() < kStretched;
                              }))
          << limb << " " << direction.transpose();
    }
  }
}

}  // namespace limb_search_test
}  // namespace abstand::tracking
