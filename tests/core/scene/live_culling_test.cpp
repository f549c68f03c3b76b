// Live pairs rest on bounds of speed, which are watched.
#include "core/scene/live_culling.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/base/error.hpp"
#include "core/scene/pair_threads.hpp"
#include "tests/core/scene/crowd.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::scene {
namespace live_culling_test {

using testing::at;
using testing::queried;
using testing::sameBits;

// The nearest points lie on the exact surfaces of shapes within this.
constexpr double kOnSurface = 1e-6;

/// Two balls with a margin of 5 cm each, on one group that is asked one publication after the other.
class LiveCullingOfPairs : public ::testing::Test {
 protected:
  LiveCullingOfPairs() {
    scene_.addObject({"still", "g", testing::ball(20), 0.05});
    scene_.addObject({"goer", "g", testing::ball(20), 0.05});
    scene_.addPair(ObjectId(0), ObjectId(1));
    scene_.setCulling({.rest = 1.0});
    scene_.setPose(ObjectId(0), at(0.0), 0.0);
    scene_.setPose(ObjectId(1), at(2.4), 0.0);
  }

  void begin() {
    threads_ = std::make_unique<PairThreads>(scene_);
    group_ = threads_->addGroup({PairId(0)});
    threads_->start(group_);
    wait(1);
  }

  /// Bounds a wait, so that a mistake fails instead of hanging.
  void wait(long cycles) {
    for (int i = 0; i < 60000 && threads_->cycles(group_) < cycles; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_GE(threads_->cycles(group_), cycles);
    threads_->collect(results_);
  }

  /// The goer at a gap between the surfaces, at time t; true when the pair was queried.
  bool goTo(double gap, double t) {
    scene_.setPose(ObjectId(1), at(0.4 + gap), t);
    const long before = threads_->counts().checked, cycle = threads_->cycles(group_);
    threads_->publishPoses(scene_);
    wait(cycle + 1);
    return threads_->counts().checked > before;
  }

  Scene scene_;
  std::unique_ptr<PairThreads> threads_;
  PairThreads::GroupIndex group_{0};
  std::vector<query::PairResult> results_{1};
};

TEST_F(LiveCullingOfPairs, QueriesWithinTimeAllowedBySpeeds) {
  scene_.setMaxSpeed(ObjectId(0), 0.5);
  scene_.setMaxSpeed(ObjectId(1), 1.5);
  begin();
  // 2 m apart, less margins and error: some 0.9 s at 2 m/s together, though it goes at 1 m/s only.
  int queries = 0;
  double last = 0.0, longest = 0.0;
  for (int i = 1; i <= 198; ++i) {
    const double t = 0.01 * i, gap = 2.0 - t;
    scene_.setPose(ObjectId(0), at(0.0), t);
    if (goTo(gap, t)) {
      ++queries;
      longest = std::max(longest, t - last);
      last = t;
      // A live pair remembers its last query, so far away it may be off by a hundredth.
      const query::PairResult cold = queried(scene_, scene_.pairs()[0]);
      EXPECT_NEAR(results_[0].distance, cold.distance, 0.01 * cold.distance + kOnSurface);
      EXPECT_LE(results_[0].distance - results_[0].bound, cold.distance + kOnSurface);
      EXPECT_EQ(results_[0].force_a, cold.force_a);
    }
    ASSERT_LE(results_[0].distance - results_[0].bound, gap + kOnSurface) << t;
    ASSERT_GE(results_[0].distance, gap - kOnSurface) << t;
    ASSERT_EQ(results_[0].contacts, queried(scene_, scene_.pairs()[0]).contacts) << t;
  }
  EXPECT_GT(results_[0].contacts, 0) << "the margins have met";
  EXPECT_GT(longest, 0.5);
  EXPECT_LT(longest, 1.0);
  EXPECT_LT(queries, 60);
  EXPECT_EQ(scene_.speedWatch().count(), 0);
}

TEST_F(LiveCullingOfPairs, SpeedBreachEndsCullingAndIsListed) {
  scene_.setMaxSpeed(ObjectId(0), 0.0);
  scene_.setMaxSpeed(ObjectId(1), 1.0);
  begin();
  EXPECT_FALSE(goTo(1.995, 0.01));
  EXPECT_FALSE(goTo(1.990, 0.02));
  EXPECT_TRUE(goTo(1.95, 0.03)) << "4 m/s";
  EXPECT_TRUE(goTo(1.90, 0.04)) << "5 m/s, the same stretch";
  EXPECT_FALSE(goTo(1.895, 0.05));
  EXPECT_TRUE(goTo(0.2, 0.06)) << "near at one stroke";
  EXPECT_LE(results_[0].distance - results_[0].bound, 0.2 + kOnSurface);
  ASSERT_EQ(scene_.speedWatch().count(), 2);
  const SpeedBreach first = scene_.speedWatch().listed()[0];
  EXPECT_EQ(first.object, ObjectId(1));
  EXPECT_EQ(first.t, 0.03);
  EXPECT_NEAR(first.speed, 5.0, 1e-9);  // steps of 5 cm, rounded at 1 m
  EXPECT_EQ(first.bound, 1.0);
}

TEST_F(LiveCullingOfPairs, NoCullingWithoutMaxSpeed) {
  scene_.setMaxSpeed(ObjectId(1), 1.0);
  begin();
  for (int i = 1; i < 5; ++i) EXPECT_TRUE(goTo(2.0, 0.01 * i));
  EXPECT_EQ(threads_->counts().rested, 0);
}

TEST_F(LiveCullingOfPairs, UnexplainedMotionEndsCulling) {
  scene_.setMaxSpeed(ObjectId(0), 0.0);
  scene_.setMaxSpeed(ObjectId(1), 1.0);
  begin();
  EXPECT_FALSE(goTo(1.995, 0.01));
  EXPECT_TRUE(goTo(1.0, 0.01)) << "moved without time";
  EXPECT_FALSE(goTo(0.995, 0.02));
  EXPECT_TRUE(goTo(0.5, 0.001)) << "a jump back in time";
  scene_.setMargin(ObjectId(0), 0.3);
  EXPECT_TRUE(goTo(0.5, 0.002)) << "a new margin";
  scene_.setMargin(ObjectId(0), 0.05);
  goTo(0.5, 0.003);
  EXPECT_FALSE(goTo(0.5, 0.004));
  scene_.setMaxSpeed(ObjectId(1), 0.5);
  EXPECT_TRUE(goTo(0.5, 0.005)) << "a new bound";
  EXPECT_EQ(scene_.speedWatch().count(), 0);
}

TEST_F(LiveCullingOfPairs, RarelyPosedObjectUsesItsOwnTime) {
  // The goer's pose of t = 0 is used at t = 0.5, where the other one is posed; then it has 0.51 s to come.
  scene_.setMaxSpeed(ObjectId(0), 0.0);
  scene_.setMaxSpeed(ObjectId(1), 2.0);
  begin();
  scene_.setPose(ObjectId(0), at(0.0), 0.5);
  threads_->publishPoses(scene_);
  wait(2);
  goTo(2.0 - 1.0, 0.51);
  EXPECT_EQ(scene_.speedWatch().count(), 0);
  EXPECT_LE(results_[0].distance - results_[0].bound, 1.0 + kOnSurface);
}

TEST(SpeedWatch, CountsBreachesAndListsFirst) {
  Scene scene;
  const ObjectId id = scene.addObject({"a", "g", testing::ball(20)});
  EXPECT_THROW(scene.setMaxSpeed(id, -1.0), UsageError);
  EXPECT_THROW(scene.setMaxSpeed(id, kNaN), UsageError);
  scene.setMaxSpeed(id, 1.0);
  // Turning alone: the farthest point of a ball of 0.2 m goes at 0.2 times the rate.
  Transform X = Transform::Identity();
  scene.setPose(id, X, 0.0);
  for (int i = 1; i < 600; ++i) {
    const double rate = i % 2 == 0 ? 4.9 : 5.1;  // rad/s
    X.linear() = X.linear() * Eigen::AngleAxisd(rate * 0.01, Vector3d::UnitY());
    scene.setPose(id, X, 0.01 * i);
  }
  EXPECT_EQ(scene.speedWatch().count(), 300);
  EXPECT_EQ(scene.speedWatch().listed().size(), SpeedWatch::kMaxListed);
  // Chords of 0.05 rad are shorter than their arcs by a part of 1e-4.
  EXPECT_NEAR(scene.speedWatch().listed()[7].speed, 5.1 * 0.2, 2e-4);
}

TEST(LiveCulling, HoldsForRandomMotionWithinSpeedBounds) {
  Scene scene;
  for (int i = 0; i < 2; ++i) scene.addObject({"ball" + std::to_string(i), "g", testing::ball(20 + i), 0.01});
  scene.addPair(ObjectId(0), ObjectId(1));
  const double speeds[] = {0.7, 2.0};
  long rested = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    LiveCulling rest;
    query::PairResult result;
    for (int i = 0; i < 100; ++i) {
      LiveObject now[2];
      Vector3d p[2];
      for (std::uint32_t k = 0; k < 2; ++k) {
        const ObjectId id(k);
        const double t =
            i == 0 ? 0.0 : scene.object(id).t + 0.02 * testing::randomUnit(seed + 7 * k, 10 + 2 * i);
        Transform X = i == 0 ? testing::randomPose(seed + 5000 * k, 1.5) : scene.object(id).X_WB;
        // As fast as it may, towards the other and past it.
        const Vector3d aim = testing::randomPose(seed + 31 * k, 1.0).translation() - X.translation();
        if (i > 0) X.translation() += aim.normalized() * speeds[k] * (t - scene.object(id).t);
        scene.setPose(id, X, t);
        now[k] = {t, 0, speeds[k]};
        p[k] = X.translation();
      }
      const Pair& pair = scene.pairs()[0];
      const Transform &X_WA = scene.object(pair.a).X_WB, &X_WB = scene.object(pair.b).X_WB;
      if (rest.mayCull(now[0], now[1], pair.options.margin)) {
        ++rested;
        rest.carry(X_WA, X_WB, now[0], now[1], result);
        ASSERT_EQ(queried(scene, pair).contacts, 0);
      } else {
        result = queried(scene, pair);
        const auto& a = *scene.object(pair.a).spec.structure;
        const auto& b = *scene.object(pair.b).spec.structure;
        rest.update(result, {X_WA, now[0]}, {X_WB, now[1]}, contactDistance(a, b, pair.options),
                    pair.options.margin, 1.0);
      }
      const double exact = (p[0] - p[1]).norm() - 0.2 - 0.21;
      if (exact > 0.0) {
        ASSERT_LE(result.distance - result.bound, exact + kOnSurface) << seed;
        ASSERT_GE(result.distance, exact - kOnSurface) << seed;
      }
    }
  }
  EXPECT_GT(rested, 2000);
}

}  // namespace live_culling_test
}  // namespace abstand::scene
