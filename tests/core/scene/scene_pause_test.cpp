// Paused pairs and the age of results.
#include <gtest/gtest.h>

#include <cmath>

#include "core/view/snapshot.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::scene {
namespace scene_pause_test {

/// Three balls of 5 cm in a row along x: a and b overlap by 2 cm, c stands 10 cm beyond b.
class PausedPairs : public ::testing::Test {
 protected:
  PausedPairs() {
    const auto ball = structure::buildHapticStructure("ball", geometry::makeSurface(geometry::Sphere{0.05}),
                                                      {.voxel_size = 0.01, .point_spacing = 0.01});
    for (const char* name : {"a", "b", "c"}) scene_.addObject({name, "objects", ball, 0.0});
    ab_ = scene_.addPair(ObjectId(0), ObjectId(1));
    bc_ = scene_.addPair(ObjectId(1), ObjectId(2));
    place(0, 0.0, 0.0);
    place(1, 0.08, 0.0);
    place(2, 0.28, 0.0);
    scene_.step();
  }

  void place(std::uint32_t object, double x, double t) {
    Transform X = Transform::Identity();
    X.translation().x() = x;
    scene_.setPose(ObjectId(object), X, t);
  }

  Scene scene_;
  PairId ab_{0}, bc_{0};
};

TEST_F(PausedPairs, AreStaleAndExcludedFromTotals) {
  const query::PairResult before = scene_.result(ab_);
  ASSERT_GT(before.contacts, 0);
  ASSERT_EQ(scene_.nearest(), ab_);
  scene_.setPaused(ab_, true, 1.0);
  EXPECT_EQ(scene_.pausedCount(), 1u);
  place(0, -0.5, 2.0);
  scene_.step();
  EXPECT_EQ(scene_.result(ab_).distance, before.distance) << "what it was, and stale";
  EXPECT_EQ(scene_.pairUncertainty(ab_), kInfinity);
  EXPECT_EQ(scene_.pairUncertainty(bc_), 0.0);
  EXPECT_EQ(scene_.ageOf(ab_, 3.5), 2.5);
  EXPECT_EQ(scene_.ageOf(ab_, 0.5), kInfinity) << "a jump back to before the pause";
  EXPECT_EQ(scene_.ageOf(bc_, 3.5), 0.0);
  EXPECT_EQ(scene_.nearest(), bc_);
  EXPECT_TRUE(scene_.touching().empty());
  for (const Object& o : scene_.objects()) {
    EXPECT_FALSE(o.colliding);
    EXPECT_EQ(o.contact.force, Vector3d(Vector3d::Zero()));
  }
}

TEST_F(PausedPairs, AreQueriedInTheStepAfterThePause) {
  scene_.setPaused(ab_, true, 1.0);
  place(0, -0.5, 2.0);
  scene_.step();
  scene_.setPaused(ab_, false, 3.0);
  scene_.step();
  EXPECT_NEAR(scene_.result(ab_).distance, 0.48, 1e-3);
  EXPECT_EQ(scene_.ageOf(ab_, 3.5), 0.0);
  EXPECT_EQ(scene_.pairUncertainty(ab_), 0.0);
  EXPECT_EQ(scene_.pausedCount(), 0u);
}

TEST_F(PausedPairs, PauseWithinOneStepHasNoEffect) {
  const Vector3d force = scene_.object(ObjectId(0)).contact.force;
  scene_.setPaused(ab_, true, 1.0);
  scene_.setPaused(ab_, false, 1.0);
  scene_.step();
  EXPECT_EQ(scene_.object(ObjectId(0)).contact.force, force);
  EXPECT_EQ(scene_.nearest(), ab_);
}

TEST_F(PausedPairs, AreInfinitelyOldWithoutResult) {
  const auto ball = scene_.object(ObjectId(0)).spec.structure;
  scene_.addObject({"d", "objects", ball, 0.0});
  const PairId ad = scene_.addPair(ObjectId(0), ObjectId(3));
  EXPECT_EQ(scene_.ageOf(ad, 1.0), kInfinity);
  scene_.setPaused(ad, true, 1.0);
  scene_.step();
  EXPECT_EQ(scene_.ageOf(ad, 2.0), kInfinity);
  EXPECT_TRUE(std::isnan(scene_.result(ad).distance));
}

TEST_F(PausedPairs, AppearInSnapshot) {
  view::SceneSnapshot snapshot;
  view::capture(scene_, snapshot);
  EXPECT_FALSE(snapshot.pairs[0].paused);
  scene_.setPaused(ab_, true, 1.0);
  scene_.step();
  view::capture(scene_, snapshot);
  EXPECT_TRUE(snapshot.pairs[0].paused);
  EXPECT_EQ(snapshot.nearest_pair, 1);
  scene_.setPaused(ab_, false, 1.0);
  scene_.step();
  view::capture(scene_, snapshot);
  EXPECT_FALSE(snapshot.pairs[0].paused);
}

TEST_F(PausedPairs, StayPausedWhenResultsAreApplied) {
  const double before = scene_.result(ab_).distance;
  scene_.setPaused(ab_, true, 1.0);
  query::PairResult other;
  other.distance = 7.0;
  const std::vector<double> times{2.0, 2.5};
  scene_.setResults({other, other}, times);
  EXPECT_EQ(scene_.result(ab_).distance, before);
  EXPECT_EQ(scene_.result(bc_).distance, 7.0);
  EXPECT_EQ(scene_.ageOf(ab_, 3.0), 2.0);
  EXPECT_EQ(scene_.ageOf(bc_, 3.0), 0.5);
  EXPECT_TRUE(scene_.touching().empty());
  // A step after that looks at everything again, moved or not.
  scene_.step();
  EXPECT_NEAR(scene_.result(bc_).distance, 0.1, 1e-3);
  EXPECT_EQ(scene_.ageOf(bc_, 3.0), 0.0);
}

TEST_F(PausedPairs, PauseAndResumeWithoutAllocation) {
  scene_.setPaused(ab_, true, 1.0);
  scene_.step();
  const testing::NoAlloc no_alloc;
  for (int i = 0; i < 10; ++i) {
    scene_.setPaused(ab_, i % 2 == 0, 1.0 + i);
    place(0, 0.01 * i, 1.0 + i);
    scene_.step();
  }
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace scene_pause_test
}  // namespace abstand::scene
