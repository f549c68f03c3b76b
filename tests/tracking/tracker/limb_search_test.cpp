// Limbs that reach for points.
#include "tracking/tracker/limb_search.hpp"

#include <gtest/gtest.h>

#include "tests/support/random_pose.hpp"

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

}  // namespace limb_search_test
}  // namespace abstand::tracking
