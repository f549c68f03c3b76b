// Live pair threads: results, sleep, pause, and changes while they run.
#include "core/scene/pair_threads.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "core/base/error.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::scene {
namespace pair_threads_test {

/// Bounds a wait, so that a mistake fails instead of hanging; far more than any machine needs.
constexpr int kMaxWaits = 60000;

bool waitFor(const std::function<bool()>& condition) {
  for (int i = 0; i < kMaxWaits; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

class LiveScene : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kObjects = 5, kPairs = 10;

  LiveScene() {
    static const auto structure = structure::buildHapticStructure(
        "ball", geometry::makeSurface(geometry::Sphere{0.05}), {.voxel_size = 0.01, .point_spacing = 0.01});
    for (std::uint32_t i = 0; i < kObjects; ++i)
      scene_.addObject({"ball " + std::to_string(i), "objects", structure, 0.0});
    for (std::uint32_t a = 0; a < kObjects; ++a) {
      for (std::uint32_t b = a + 1; b < kObjects; ++b) scene_.addPair(ObjectId(a), ObjectId(b));
    }
    move(0.0);
  }

  /// New poses for all, close enough that some touch.
  void move(double t) {
    ++moves_;
    for (std::uint32_t i = 0; i < kObjects; ++i) {
      scene_.setPose(ObjectId(i), testing::randomPose(100 * moves_ + i, 0.12), t);
    }
  }

  static std::vector<PairId> pairIds(std::uint32_t begin, std::uint32_t end) {
    std::vector<PairId> out;
    for (std::uint32_t i = begin; i < end; ++i) out.emplace_back(i);
    return out;
  }

  /// What a pair remembers differs, as a live group need not see every pose; so the nearest points may be
  /// others, within what queryPair() allows.
  static void expectSame(const query::PairResult& live, const query::PairResult& step) {
    const double allowed = std::max(0.01 * std::abs(step.distance), 1e-3);
    EXPECT_NEAR(live.distance, step.distance, allowed);
    EXPECT_LE(live.distance - live.bound, step.distance + 1e-9);
    EXPECT_LE(step.distance - step.bound, live.distance + 1e-9);
    EXPECT_EQ(live.force_a, step.force_a);
    EXPECT_EQ(live.torque_b, step.torque_b);
    EXPECT_EQ(live.contacts, step.contacts);
  }

  /// Collects until all pairs have results of time t.
  bool collectUntil(PairThreads& threads, const std::vector<PairId>& pairs, double t) {
    return waitFor([&] {
      cycles_ += threads.collect(results_);
      for (const PairId pair : pairs) {
        if (threads.resultTime(pair) != t) return false;
      }
      return true;
    });
  }

  Scene scene_;
  std::vector<query::PairResult> results_{kPairs};
  long cycles_{0};
  std::uint64_t moves_{0};
};

TEST_F(LiveScene, MatchesLockStepWithinWarmStartTolerance) {
  PairThreads threads(scene_);
  for (std::uint32_t g = 0; g < 3; ++g) {
    threads.start(threads.addGroup(pairIds(g * kPairs / 3, (g + 1) * kPairs / 3)));
  }
  int touching = 0;
  for (int k = 1; k <= 30; ++k) {
    move(0.1 * k);
    scene_.setMargin(ObjectId(0), 0.001 * k);
    threads.publishPoses(scene_);
    ASSERT_TRUE(collectUntil(threads, pairIds(0, kPairs), 0.1 * k));
    ASSERT_TRUE(threads.upToDate());
    scene_.step();
    for (std::uint32_t i = 0; i < kPairs; ++i) {
      expectSame(results_[i], scene_.result(PairId(i)));
      touching += results_[i].contacts > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(touching, 0);
}

TEST_F(LiveScene, IsBitIdenticalToLockStepWithSamePoses) {
  scene_.setCulling({.remember = true});
  scene_.step();
  PairThreads threads(scene_);
  std::vector<PairThreads::GroupIndex> groups;
  for (std::uint32_t g = 0; g < 3; ++g) {
    groups.push_back(threads.addGroup(pairIds(g * kPairs / 3, (g + 1) * kPairs / 3)));
    threads.start(groups.back());
  }
  // Each thread looks at the first poses too before there are others.
  for (const auto group : groups) ASSERT_TRUE(waitFor([&] { return threads.cycles(group) == 1; }));
  for (int k = 1; k <= 30; ++k) {
    move(0.1 * k);
    threads.publishPoses(scene_);
    ASSERT_TRUE(collectUntil(threads, pairIds(0, kPairs), 0.1 * k));
    scene_.step();
    for (std::uint32_t i = 0; i < kPairs; ++i) {
      const query::PairResult &live = results_[i], &step = scene_.result(PairId(i));
      ASSERT_EQ(live.distance, step.distance);
      ASSERT_EQ(live.bound, step.bound);
      ASSERT_EQ(live.witness_a, step.witness_a);
      ASSERT_EQ(live.witness_b, step.witness_b);
      ASSERT_EQ(live.force_a, step.force_a);
      ASSERT_EQ(live.torque_a, step.torque_a);
      ASSERT_EQ(live.torque_b, step.torque_b);
      ASSERT_EQ(live.contacts, step.contacts);
    }
  }
}

TEST_F(LiveScene, AcceptsBackwardTimeJump) {
  PairThreads threads(scene_);
  threads.start(threads.addGroup(pairIds(0, kPairs)));
  for (const double t : {5.0, 1.0, 3.0}) {
    move(t);
    threads.publishPoses(scene_);
    ASSERT_TRUE(collectUntil(threads, pairIds(0, kPairs), t));
  }
}

TEST_F(LiveScene, HasResultsBeforeThreadsRun) {
  move(2.0);
  PairThreads threads(scene_);
  threads.addGroup(pairIds(0, 4));
  EXPECT_EQ(threads.collect(results_), 0);
  scene_.step();
  for (std::uint32_t i = 0; i < 4; ++i) {
    expectSame(results_[i], scene_.result(PairId(i)));
    EXPECT_EQ(threads.resultTime(PairId(i)), 2.0);
  }
  EXPECT_EQ(threads.resultTime(PairId(4)), -kInfinity);
}

TEST_F(LiveScene, IdleGroupRunsAtMostOneCyclePerPublication) {
  PairThreads threads(scene_);
  const auto group = threads.addGroup(pairIds(0, kPairs));
  threads.start(group);
  for (int k = 1; k <= 20; ++k) {
    move(k);
    threads.publishPoses(scene_);
    ASSERT_TRUE(collectUntil(threads, pairIds(0, kPairs), k));
    EXPECT_LE(threads.cycles(group), k + 1);
  }
  threads.stop(group);
  cycles_ += threads.collect(results_);
  EXPECT_EQ(cycles_, threads.cycles(group));
}

TEST_F(LiveScene, PausedGroupSleepsWhileOthersRun) {
  PairThreads threads(scene_);
  const auto paused = threads.addGroup(pairIds(0, 5)), other = threads.addGroup(pairIds(5, kPairs));
  threads.start(paused);
  threads.start(other);
  move(1.0);
  threads.publishPoses(scene_);
  ASSERT_TRUE(collectUntil(threads, pairIds(0, kPairs), 1.0));
  // All that was asked for is done, so no cycle is under way.
  threads.pause(paused);
  const long before = threads.cycles(paused);
  for (int k = 2; k <= 20; ++k) {
    move(k);
    threads.publishPoses(scene_);
    ASSERT_TRUE(collectUntil(threads, pairIds(5, kPairs), k));
  }
  EXPECT_EQ(threads.cycles(paused), before);
  EXPECT_EQ(threads.resultTime(PairId(0)), 1.0);
  threads.start(paused);
  EXPECT_TRUE(collectUntil(threads, pairIds(0, kPairs), 20.0));
  EXPECT_EQ(threads.cycles(paused), before + 1);
}

TEST_F(LiveScene, StoppedGroupCanRestart) {
  PairThreads threads(scene_);
  const auto group = threads.addGroup(pairIds(0, kPairs));
  for (int k = 1; k <= 10; ++k) {
    threads.start(group);
    move(k);
    threads.publishPoses(scene_);
    ASSERT_TRUE(collectUntil(threads, pairIds(0, kPairs), k));
    threads.stop(group);
    EXPECT_GE(threads.cycles(group), 1);
    EXPECT_LE(threads.cycles(group), 2);
  }
}

TEST_F(LiveScene, PairsMoveBetweenRunningGroups) {
  PairThreads threads(scene_);
  const auto one = threads.addGroup(pairIds(0, 5)), two = threads.addGroup(pairIds(5, kPairs));
  threads.start(one);
  threads.start(two);
  threads.removePair(one, PairId(3));
  move(1.0);
  threads.publishPoses(scene_);
  const double left_at = threads.resultTime(PairId(3));
  ASSERT_TRUE(collectUntil(threads, pairIds(4, kPairs), 1.0));
  EXPECT_EQ(threads.resultTime(PairId(3)), left_at);
  threads.addPair(two, PairId(3));
  EXPECT_EQ(threads.resultTime(PairId(3)), 1.0) << "a first result at once";
  move(2.0);
  threads.publishPoses(scene_);
  ASSERT_TRUE(collectUntil(threads, pairIds(0, kPairs), 2.0));
  scene_.step();
  for (std::uint32_t i = 0; i < kPairs; ++i) expectSame(results_[i], scene_.result(PairId(i)));
}

TEST_F(LiveScene, RejectsPairsInTwoGroups) {
  PairThreads threads(scene_);
  const auto one = threads.addGroup(pairIds(0, 5)), two = threads.addGroup({});
  EXPECT_THROW(threads.addGroup(pairIds(4, 6)), UsageError);
  EXPECT_THROW(threads.addGroup({PairId(7), PairId(7)}), UsageError);
  EXPECT_THROW(threads.addPair(two, PairId(0)), UsageError);
  EXPECT_THROW(threads.removePair(two, PairId(0)), UsageError);
  threads.removePair(one, PairId(0));
  EXPECT_NO_THROW(threads.addPair(two, PairId(0)));
  EXPECT_NO_THROW(threads.addPair(two, PairId(7)));
}

TEST_F(LiveScene, OwnerAllocatesNothingInCycle) {
  PairThreads threads(scene_);
  threads.start(threads.addGroup(pairIds(0, 5)));
  threads.start(threads.addGroup(pairIds(5, kPairs)));
  const testing::NoAlloc no_alloc;
  for (int k = 0; k < 50; ++k) {
    threads.publishPoses(scene_);
    threads.collect(results_);
  }
  EXPECT_EQ(no_alloc.count(), 0);
}

TEST_F(LiveScene, ConcurrentChangesKeepResultsFinite) {
  constexpr std::size_t kGroups = 3;
  PairThreads threads(scene_);
  for (std::size_t g = 0; g < kGroups; ++g) threads.addGroup({});
  std::vector<std::size_t> group_of(kPairs, kGroups);
  long before = 0;
  for (std::uint64_t k = 0; k < 600; ++k) {
    const auto pick = [&](std::uint64_t stream, double n) {
      return static_cast<std::uint32_t>(n * testing::randomUnit(k + 1, stream));
    };
    const std::size_t group = pick(0, kGroups);
    const std::uint32_t pair = pick(1, kPairs);
    switch (pick(2, 6)) {
      case 0:
        threads.start(group);
        break;
      case 1:
        threads.pause(group);
        break;
      case 2:
        threads.stop(group);
        break;
      case 3:
        if (group_of[pair] == kGroups) threads.addPair(group_of[pair] = group, PairId(pair));
        break;
      case 4:
        if (group_of[pair] != kGroups) threads.removePair(group_of[pair], PairId(pair));
        group_of[pair] = kGroups;
        break;
      default:
        move(static_cast<double>(k));
        threads.publishPoses(scene_);
    }
    // Gives the threads time to run in between, also on one core.
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    cycles_ += threads.collect(results_);
    ASSERT_GE(cycles_, before);
    before = cycles_;
    for (std::uint32_t i = 0; i < kPairs; ++i) {
      if (threads.resultTime(PairId(i)) == -kInfinity) continue;
      ASSERT_TRUE(std::isfinite(results_[i].distance) && results_[i].force_a.allFinite());
      ASSERT_TRUE(results_[i].witness_a.allFinite() && results_[i].torque_a.allFinite());
    }
  }
  // In the end all catch up with the last poses.
  for (std::size_t g = 0; g < kGroups; ++g) threads.start(g);
  move(1e4);
  threads.publishPoses(scene_);
  std::vector<PairId> grouped;
  for (std::uint32_t i = 0; i < kPairs; ++i) {
    if (group_of[i] != kGroups) grouped.emplace_back(i);
  }
  ASSERT_FALSE(grouped.empty());
  EXPECT_TRUE(collectUntil(threads, grouped, 1e4));
}

}  // namespace pair_threads_test
}  // namespace abstand::scene
