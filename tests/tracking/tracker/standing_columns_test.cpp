// Which points stand on the floor: posts, hanging hands, tables.
#include "tracking/tracker/standing_columns.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/no_alloc.hpp"

namespace abstand::tracking {
namespace standing_columns_test {

constexpr float kStep = 0.02f;  // m, between points

/// Points over (x, y) from one height to another (m), as of a surface that faces the camera.
void addPost(float x, float y, float low, float high, SeenPoints& points) {
  for (float z = low; z < high; z += kStep) {
    const std::size_t i = points.count++;
    points.x[i] = x, points.y[i] = y, points.z[i] = z;
    points.no_arm[i] = 0.0f;
  }
}

struct StandingColumns : ::testing::Test {
  std::unique_ptr<SeenPoints> points = std::make_unique<SeenPoints>();
  /// Highest marked height (m); 0: none.
  float highestMarked() const {
    float highest = 0.0f;
    for (std::size_t i = 0; i < points->count; ++i)
      if (points->no_arm[i] > 0.0f) highest = std::max(highest, points->z[i]);
    return highest;
  }
};

TEST_F(StandingColumns, MarkAPostUpToItsTop) {
  addPost(0.2f, -0.2f, 0.08f, 0.37f, *points);
  markStanding(*points);
  for (std::size_t i = 0; i < points->count; ++i) EXPECT_EQ(points->no_arm[i], kNoArm) << points->z[i];
}

TEST_F(StandingColumns, LeaveAHangingHand) {
  addPost(0.1f, 0.3f, 0.27f, 0.54f, *points);
  addPost(0.3f, 0.1f, 0.08f, 0.40f, *points);  // a shin elsewhere
  markStanding(*points);
  for (std::size_t i = 0; i < points->count; ++i)
    EXPECT_EQ(points->no_arm[i] > 0.0f, points->x[i] > 0.2f) << points->z[i];
}

TEST_F(StandingColumns, EndAtAGap) {
  addPost(0.2f, 0.2f, 0.08f, 0.22f, *points);  // a foot
  addPost(0.2f, 0.2f, 0.40f, 0.54f, *points);  // a hand above it
  markStanding(*points);
  EXPECT_GT(highestMarked(), 0.15f);
  EXPECT_LT(highestMarked(), 0.25f);
}

TEST_F(StandingColumns, LeaveAHandInFrontOfAShin) {
  addPost(0.2f, 0.2f, 0.08f, 0.50f, *points);
  addPost(0.3f, 0.2f, 0.30f, 0.50f, *points);
  markStanding(*points);
  for (std::size_t i = 0; i < points->count; ++i)
    EXPECT_EQ(points->no_arm[i] > 0.0f, points->x[i] < 0.25f) << points->z[i];
}

TEST_F(StandingColumns, LeaveWhatIsHigher) {
  addPost(0.2f, 0.2f, 0.08f, 1.2f, *points);
  markStanding(*points);
  EXPECT_GT(highestMarked(), 0.5f);
  EXPECT_LT(highestMarked(), kStandingBelow);
}

TEST_F(StandingColumns, MarkNothingOutsideOfTheGridAndAllocateNothing) {
  addPost(0.0f, 0.0f, 0.08f, 0.4f, *points);
  const std::size_t near = points->count;
  addPost(50.0f, 50.0f, 0.08f, 0.4f, *points);
  testing::NoAlloc guard;
  markStanding(*points);
  EXPECT_EQ(guard.count(), 0);
  for (std::size_t i = 0; i < points->count; ++i) EXPECT_EQ(points->no_arm[i] > 0.0f, i < near);
}

}  // namespace standing_columns_test
}  // namespace abstand::tracking
