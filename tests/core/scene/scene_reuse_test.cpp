// Pairs of bodies that have not moved keep their results, which are those that a query would give again.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/state_hash.hpp"
#include "core/view/snapshot.hpp"
#include "tests/core/scene/crowd.hpp"
#include "tests/core/scene/drift.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::scene {
namespace scene_reuse_test {

using testing::at;
using testing::crowd;
using testing::queried;
using testing::sameBits;
using testing::scatter;

void expectAllQueried(const Scene& scene) {
  std::vector<PairId> touching;
  std::optional<PairId> nearest;
  for (std::uint32_t i = 0; i < scene.pairs().size(); ++i) {
    const query::PairResult expected = queried(scene, scene.pairs()[i]);
    ASSERT_TRUE(sameBits(scene.pairs()[i].result, expected)) << "pair " << i;
    if (expected.contacts > 0) touching.emplace_back(i);
    if (!nearest || expected.distance < scene.result(*nearest).distance) nearest = PairId(i);
  }
  EXPECT_EQ(scene.touching(), touching);
  EXPECT_EQ(scene.nearest(), nearest);
}

/// Totals as sums over all pairs, in order.
void expectTotals(const Scene& scene) {
  std::vector<Wrench> sums(scene.objectCount());
  for (const Pair& p : scene.pairs()) {
    sums[p.a.index()] += {p.result.force_a, p.result.torque_a};
    sums[p.b.index()] += {-p.result.force_a, p.result.torque_b};
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    EXPECT_EQ(scene.objects()[i].contact.force, sums[i].force);
    EXPECT_EQ(scene.objects()[i].contact.torque, sums[i].torque);
  }
}

TEST(SceneReuse, QueriesOnlyPairsOfMovedObjects) {
  for (const int threads : {1, 3}) {
    Scene scene = crowd(12);
    scene.setThreads(threads);
    scatter(scene, 0);
    scene.step();
    EXPECT_EQ(scene.updated().size(), 66u);
    scene.step();
    EXPECT_EQ(scene.updated().size(), 0u) << "nothing moved";
    expectAllQueried(scene);

    std::size_t touched = 0;
    for (std::uint32_t frame = 1; frame < 200; ++frame) {
      // Two or three move, among them one with the pose that it has already.
      const ObjectId first(frame % 12), second((frame / 3) % 12), still((frame + 5) % 12);
      scene.setPose(first, testing::randomPose(frame + 9000), 0.01 * frame);
      scene.setPose(second, testing::randomPose(frame + 5000), 0.01 * frame);
      scene.setPose(still, scene.object(still).X_WB, 0.01 * frame);
      scene.step();
      ASSERT_EQ(scene.updated().size(), first == second ? 11u : 21u);
      expectAllQueried(scene);
      expectTotals(scene);
      touched += scene.touching().size();
    }
    EXPECT_GT(touched, 200u) << "the crowd must touch for this test to mean something";
  }
}

TEST(SceneReuse, MarginsForceLawAndNewPairsTriggerQueries) {
  Scene scene = crowd(6);
  scatter(scene, 0);
  scene.step();
  scene.setMargin(ObjectId(2), 0.3);
  scene.setMargin(ObjectId(2), 0.2);
  scene.step();
  EXPECT_EQ(scene.updated().size(), 5u);
  expectAllQueried(scene);
  scene.setForceLaw(query::ForceLaw::kThesis, 100.0);
  scene.step();
  expectAllQueried(scene);
  const ObjectId late = scene.addObject({"late", "objects", testing::ball(20)});
  scene.setPose(late, at(0.1), 0.0);
  scene.addPair(ObjectId(3), late);
  scene.step();
  EXPECT_EQ(scene.updated().size(), 1u);
  expectAllQueried(scene);
  expectTotals(scene);
}

TEST(SceneReuse, RejectedPoseTriggersNoQuery) {
  Scene scene = crowd(3);
  scatter(scene, 0);
  scene.step();
  EXPECT_FALSE(scene.setPose(ObjectId(1), at(kNaN), 1.0));
  scene.step();
  EXPECT_TRUE(scene.updated().empty());
}

TEST(SceneReuse, SnapshotCopiesUpdatedPairs) {
  Scene scene = crowd(10);
  view::SceneSnapshot often, rare;
  for (std::uint32_t frame = 0; frame < 60; ++frame) {
    scene.setPose(ObjectId(frame % 10), testing::randomPose(frame), 0.01 * frame);
    if (frame % 7 == 3) scene.setMargin(ObjectId((frame + 4) % 10), 0.001 * frame);
    scene.step();
    view::capture(scene, often);
    if (frame % 13 != 0) continue;
    view::capture(scene, rare);
    for (const view::SceneSnapshot* s : {&often, &rare})
      for (std::size_t i = 0; i < scene.pairs().size(); ++i) {
        ASSERT_TRUE(sameBits(s->pairs[i].result, scene.pairs()[i].result)) << frame << " " << i;
        ASSERT_EQ(s->pairs[i].margin, scene.pairs()[i].options.margin);
      }
  }
}

TEST(SceneReuse, PartialStepsAllocateNothing) {
  Scene scene = crowd(12);
  scene.setThreads(2);
  scatter(scene, 0);
  scene.step();
  const testing::NoAlloc guard;
  for (std::uint32_t frame = 1; frame < 100; ++frame) {
    scene.setPose(ObjectId(frame % 12), testing::randomPose(frame), 0.01 * frame);
    scene.step();
  }
  EXPECT_EQ(guard.count(), 0);
}

// What a pair may be too far by: 1 % beyond 0.1 m, and half a spacing where a corner is between points; else
// what a walk along the surfaces leaves (witness.hpp).
double tooFar(double distance) { return distance > 0.1 ? 0.01 * distance + 0.0025 : 1e-3 * distance + 1e-5; }

TEST(ScenePairCache, IsWithinToleranceAndIndependentOfThreads) {
  Scene one = testing::longBodies(), three = testing::longBodies();
  one.setCulling({.remember = true});
  three.setCulling({.remember = true});
  three.setThreads(3);
  testing::Drift drift(one), same_drift(three);
  long apart = 0, touching = 0;
  for (int frame = 0; frame < 400; ++frame) {
    drift.frame(frame);
    same_drift.frame(frame);
    one.step();
    three.step();
    for (std::uint32_t i = 0; i < one.pairs().size(); ++i) {
      const query::PairResult& remembered = one.pairs()[i].result;
      ASSERT_TRUE(sameBits(remembered, three.pairs()[i].result)) << frame;
      const query::PairResult fresh = queried(one, one.pairs()[i]);
      ASSERT_LE(remembered.distance - remembered.bound, fresh.distance + 1e-9) << frame;
      ASSERT_LE(fresh.distance - fresh.bound, remembered.distance + 1e-9) << frame;
      ASSERT_EQ(remembered.force_a, fresh.force_a) << frame;
      if (fresh.distance > 0.0) {
        ASSERT_LE(remembered.distance, fresh.distance + tooFar(fresh.distance)) << frame;
        ++apart;
      }
      touching += fresh.contacts > 0;
    }
  }
  EXPECT_GT(apart, 1000);
  EXPECT_GT(touching, 10);
}

TEST(ScenePairCache, SwitchingOffDiscardsPairCache) {
  Scene scene = crowd(9);
  testing::Drift drift(scene);
  scene.setCulling({.remember = true});
  for (int frame = 0; frame < 20; ++frame) {
    drift.frame(frame);
    scene.step();
  }
  scene.setCulling({});
  scene.step();
  expectAllQueried(scene);
}

}  // namespace scene_reuse_test
}  // namespace abstand::scene
