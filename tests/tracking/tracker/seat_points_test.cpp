// Who sits, and which points are those of a seat.
#include "tracking/tracker/seat_points.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/no_alloc.hpp"
#include "tests/tracking/tracker/seated_pose.hpp"
#include "tests/tracking/tracker/upright_person.hpp"

namespace abstand::tracking {
namespace seat_points_test {

using enum humanmodel::Joint;

struct SeatPoints : ::testing::Test, SeatedPerson {
  std::unique_ptr<SeenPoints> points = std::make_unique<SeenPoints>(), seat = std::make_unique<SeenPoints>();

  void add(const Vector3d& p) {
    const std::size_t i = points->count++;
    points->x[i] = static_cast<float>(p.x());
    points->y[i] = static_cast<float>(p.y());
    points->z[i] = static_cast<float>(p.z());
  }
};

TEST_F(SeatPoints, LevelThighsOnAChairSit) {
  EXPECT_TRUE(sitsOnSeat(rig, X_WS));
  EXPECT_FALSE(sitsOnSeat(rig, uprightAt(rig, Vector3d::Zero()))) << "stands";
  RigPose low = seatedPose(rig);
  low.X_WP.translation().z() = 0.12;
  place(rig, low, X_WS);
  EXPECT_FALSE(sitsOnSeat(rig, X_WS)) << "sits on the floor";
}

TEST_F(SeatPoints, LegsOfAPersonWhoKneelsAreNoSeat) {
  RigPose pose = seatedPose(rig);
  for (const RigSegment thigh : {RigSegment::kThighLeft, RigSegment::kThighRight})
    pose.R_PS[index(thigh)] = Quaterniond::Identity();
  place(rig, pose, X_WS);
  EXPECT_FALSE(sitsOnSeat(rig, X_WS));
}

TEST_F(SeatPoints, EdgeAndLegsOfTheChairAreMovedOnly) {
  const Vector3d under = 0.5 * (jointAt(kHipLeft) + jointAt(kKneeLeft));
  const Vector3d edge = under - (kUnderThighs + 0.02) * Vector3d::UnitZ();
  const Vector3d leg{edge.x(), 0.25, 0.15};
  const Vector3d thigh = under - (kUnderThighs - 0.02) * Vector3d::UnitZ();
  const Vector3d calf = 0.5 * (jointAt(kKneeLeft) + jointAt(kAnkleLeft)) + 0.06 * Vector3d::UnitX();
  const Vector3d toe = jointAt(kToeRight) + 0.03 * Vector3d::UnitX();
  for (const Vector3d& p : {thigh, edge, calf, leg, toe}) add(p);
  testing::NoAlloc guard;
  const std::size_t moved = moveSeatPoints(rig, X_WS, *points, *seat);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(moved, 2u);
  ASSERT_EQ(seat->count, 2u);
  EXPECT_TRUE(seat->point(0).isApprox(edge, 1e-5));
  EXPECT_TRUE(seat->point(1).isApprox(leg, 1e-5));
  ASSERT_EQ(points->count, 3u);
  EXPECT_TRUE(points->point(0).isApprox(thigh, 1e-5)) << "in order";
  EXPECT_TRUE(points->point(1).isApprox(calf, 1e-5));
  EXPECT_TRUE(points->point(2).isApprox(toe, 1e-5));
}

TEST_F(SeatPoints, LegsThatAreSomewhereElseAreLeft) {
  const Vector3d low{0.0, 0.0, 0.2};
  add(low +
      Vector3d(jointAt(kKneeLeft).x() + 0.2, 0.0, 0.0));  // stretched ahead, between the calves of the pose
  add(low + Vector3d(0.2, kHalfSeat + 0.05, 0.0));        // to the side
  EXPECT_EQ(moveSeatPoints(rig, X_WS, *points, *seat), 0u);
  EXPECT_EQ(points->count, 2u);
}

TEST_F(SeatPoints, WithoutRoomAreLost) {
  seat->count = SeenPoints::kMax;
  add(0.5 * (jointAt(kHipLeft) + jointAt(kKneeLeft)) - 0.2 * Vector3d::UnitZ());
  EXPECT_EQ(moveSeatPoints(rig, X_WS, *points, *seat), 1u);
  EXPECT_EQ(points->count, 0u);
  EXPECT_EQ(seat->count, SeenPoints::kMax);
}

}  // namespace seat_points_test
}  // namespace abstand::tracking
