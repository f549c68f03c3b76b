// A time budget a step: the answer gets coarser evenly, and says so. The clock is the test's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tests/core/scene/crowd.hpp"
#include "tests/core/scene/drift.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::scene {
namespace scene_budget_test {

using testing::at;
using testing::Drift;
using testing::longBodies;
using testing::queried;
using testing::sameBits;

// The nearest points lie on the exact surfaces of shapes within this.
constexpr double kOnSurface = 1e-6;

/// Goes on by a second with every look at it, so a budget of n seconds is n + 1 batches.
double countingClock() {
  static double seconds = 0.0;
  return seconds += 1.0;
}

/// Queries of a thread between two looks at the clock, as in the scene.
constexpr long kBatch = 8;

Scene counted(double budget) {
  Scene scene = longBodies();
  scene.setClock(countingClock);
  scene.setCulling({.budget = budget});
  return scene;
}

TEST(SceneBudget, BoundsHoldForDeferredPairs) {
  for (const double budget : {0.0, 1.0, 3.0}) {
    Scene scene = counted(budget);
    Drift drift(scene);
    long deferred = 0;
    int longest = 0;
    for (int frame = 0; frame < 1500; ++frame) {
      drift.frame(frame);
      scene.step();
      const StepCounts& counts = scene.counts();
      deferred += counts.deferred;
      longest = std::max(longest, counts.longest_wait);
      ASSERT_EQ(counts.rested + counts.beyond, 0);
      if (frame > 0) {
        ASSERT_LE(counts.checked, kBatch * (static_cast<long>(budget) + 1)) << frame;
      }
      for (const Pair& p : scene.pairs()) {
        const query::PairResult exact = queried(scene, p);
        // Inside, the distance is a depth, which changes by no more than the bodies move, too.
        ASSERT_LE(p.result.distance - p.result.bound, exact.distance + kOnSurface) << frame;
        if (p.outcome == PairOutcome::kChecked && p.waited == 0) {
          ASSERT_TRUE(sameBits(p.result, exact));
        }
      }
    }
    EXPECT_GT(deferred, 0) << budget;
    // 36 pairs in batches of 8: five steps would do if none could touch; those that may touch come first.
    EXPECT_LE(longest, budget == 0.0 ? 40 : 20) << budget;
  }
}

TEST(SceneBudget, SufficientBudgetChangesNothing) {
  Scene scene = counted(1000.0), plain = longBodies();
  Drift drift(scene), plain_drift(plain);
  for (int frame = 0; frame < 300; ++frame) {
    drift.frame(frame);
    plain_drift.frame(frame);
    scene.step();
    plain.step();
    ASSERT_EQ(scene.counts().deferred, 0);
    for (std::size_t i = 0; i < plain.pairs().size(); ++i)
      ASSERT_TRUE(sameBits(scene.pairs()[i].result, plain.pairs()[i].result)) << frame;
    for (std::size_t i = 0; i < plain.objectCount(); ++i)
      ASSERT_EQ(scene.objects()[i].contact.torque, plain.objects()[i].contact.torque);
  }
}

TEST(SceneBudget, DeferredPairsCatchUpAtStandstill) {
  Scene scene = counted(0.0);
  Drift drift(scene);
  for (int frame = 0; frame < 30; ++frame) {
    drift.frame(frame);
    scene.step();
  }
  for (int i = 0; i < 6; ++i) scene.step();
  scene.step();
  EXPECT_TRUE(scene.updated().empty());
  for (const Pair& p : scene.pairs()) EXPECT_TRUE(sameBits(p.result, queried(scene, p)));
}

TEST(SceneBudget, UrgentPairsComeFirst) {
  // One ball among 40 others on a ring about it; one of them nearly touches.
  Scene scene;
  scene.addObject({"middle", "g", testing::ball(20), 0.0});
  for (int i = 0; i < 40; ++i) {
    const auto id = scene.addObject({"ring" + std::to_string(i), "g", testing::ball(20), 0.0});
    const double reach = i == 29 ? 0.45 : 1.0 + 0.01 * i;
    scene.setPose(id, at(reach * std::cos(0.1 * i), reach * std::sin(0.1 * i)), 0.0);
    scene.addPair(ObjectId(0), id);
  }
  scene.setClock(countingClock);
  scene.setCulling({.budget = 0.0});
  scene.step();
  for (int frame = 1; frame < 40; ++frame) {
    scene.setPose(ObjectId(0), at(0.0, 0.0, 1e-4 * frame), 0.001 * frame);
    scene.step();
    ASSERT_EQ(scene.counts().checked, kBatch);
    ASSERT_EQ(scene.counts().deferred, 40 - kBatch);
    ASSERT_EQ(scene.pairs()[29].outcome, PairOutcome::kChecked) << "it may touch, so it never waits";
    // 39 others, 7 a step: none waits longer than it takes to go round.
    ASSERT_LE(scene.counts().longest_wait, 6);
  }
}

TEST(SceneBudget, DeferringStepAllocatesNothing) {
  Scene scene = counted(2.0);
  scene.setThreads(2);
  Drift drift(scene);
  drift.frame(0);
  scene.step();
  const testing::NoAlloc guard;
  for (int frame = 1; frame < 200; ++frame) {
    drift.frame(frame);
    scene.step();
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST(SceneBudget, RejectsInvalidBudget) {
  Scene scene = longBodies();
  EXPECT_THROW(scene.setCulling({.budget = -1.0}), UsageError);
  EXPECT_THROW(scene.setCulling({.budget = kNaN}), UsageError);
}

}  // namespace scene_budget_test
}  // namespace abstand::scene
