// Resting pairs: what they report holds, and what is not needed is not queried.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/state_hash.hpp"
#include "tests/core/scene/crowd.hpp"
#include "tests/core/scene/drift.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::scene {
namespace scene_rest_test {

using testing::at;
using testing::crowd;
using testing::Drift;
using testing::longBodies;
using testing::queried;
using testing::sameBits;

// The nearest points lie on the exact surfaces of shapes within this.
constexpr double kOnSurface = 1e-6;

struct RestCase {
  const char* name;
  QueryCulling culling;
};

class CullingModes : public ::testing::TestWithParam<RestCase> {};

TEST_P(CullingModes, BallsMatchDistanceOfCentres) {
  Scene scene = crowd(9);
  const QueryCulling& culling = GetParam().culling;
  scene.setCulling(culling);
  Drift drift(scene);
  StepCounts sum;
  long touching = 0;
  for (int frame = 0; frame < 3000; ++frame) {
    drift.frame(frame);
    scene.step();
    sum.checked += scene.counts().checked;
    sum.rested += scene.counts().rested;
    sum.beyond += scene.counts().beyond;
    for (const Pair& p : scene.pairs()) {
      const Vector3d way = scene.object(p.b).X_WB.translation() - scene.object(p.a).X_WB.translation();
      const double radii = 0.2 + 0.01 * p.a.index() + 0.2 + 0.01 * p.b.index();
      const double exact = way.norm() - radii;
      touching += p.result.contacts > 0;
      if (exact <= 0.0) {
        // Inside, distance is the depth of points, not that of the centres.
        ASSERT_EQ(p.outcome, PairOutcome::kChecked);
        continue;
      }
      ASSERT_LE(p.result.distance - p.result.bound, exact + kOnSurface) << frame;
      ASSERT_GE(p.result.distance, exact - kOnSurface) << frame;
      ASSERT_NEAR((p.result.witness_a - p.result.witness_b).norm(), p.result.distance, kOnSurface);
    }
  }
  EXPECT_GT(touching, 0);
  EXPECT_GT(sum.checked, 0);
  // A tenth at least, where it is asked for.
  EXPECT_GE(10 * sum.rested, culling.rest > 0.0 ? sum.checked : 0);
  EXPECT_GE(10 * sum.beyond, culling.horizon < kInfinity ? sum.checked : 0);
  EXPECT_TRUE(culling.rest > 0.0 || sum.rested == 0);
  EXPECT_TRUE(culling.horizon < kInfinity || sum.beyond == 0);
}

TEST_P(CullingModes, MatchesQueriesWithinBounds) {
  Scene scene = longBodies();
  const QueryCulling& culling = GetParam().culling;
  scene.setCulling(culling);
  Drift drift(scene);
  std::vector<query::PairResult> checked(scene.pairs().size());  // last of each pair
  for (int frame = 0; frame < 2000; ++frame) {
    drift.frame(frame);
    scene.step();
    for (const Pair& p : scene.pairs()) {
      const query::PairResult exact = queried(scene, p);
      ASSERT_EQ(p.result.contacts, exact.contacts) << frame;
      query::PairResult& last = checked[static_cast<std::size_t>(&p - scene.pairs().data())];
      if (p.outcome == PairOutcome::kChecked) {
        ASSERT_TRUE(sameBits(p.result, exact)) << frame;
        last = p.result;
        continue;
      }
      ASSERT_EQ(p.result.force_a, Vector3d(0, 0, 0));
      ASSERT_LE(p.result.distance - p.result.bound, exact.distance + kOnSurface) << frame;
      ASSERT_LE(exact.distance - exact.bound, p.result.distance + kOnSurface) << frame;
      if (p.outcome == PairOutcome::kCulled) {
        ASSERT_LE(p.result.bound, last.bound + 2.0 * culling.rest * last.distance + kOnSurface) << frame;
      }
    }
  }
}

TEST_P(CullingModes, IsBitIdenticalForAnyThreadCount) {
  std::uint64_t expected = 0;
  for (const int threads : {1, 2, 3, 7, 16}) {
    Scene scene = longBodies();
    scene.setCulling(GetParam().culling);
    scene.setThreads(threads);
    Drift drift(scene);
    StateHash hash;
    for (int frame = 0; frame < 300; ++frame) {
      drift.frame(frame);
      scene.step();
      for (const Pair& p : scene.pairs()) {
        hash.add(p.result.distance);
        hash.add(p.result.bound);
        hash.add(p.result.force_a.x());
        hash.add(p.result.witness_b.z());
        hash.add(static_cast<double>(p.outcome));
      }
      for (const Object& o : scene.objects()) hash.add(o.contact.torque.y());
    }
    if (threads == 1) expected = hash.value();
    EXPECT_EQ(hash.value(), expected) << threads;
  }
}

TEST_P(CullingModes, AllocatesNothing) {
  Scene scene = longBodies();
  scene.setCulling(GetParam().culling);
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

INSTANTIATE_TEST_SUITE_P(QueryCulling, CullingModes,
                         ::testing::Values(RestCase{"none", {}}, RestCase{"hundredth", {.rest = 0.01}},
                                           RestCase{"tenth", {.rest = 0.1}},
                                           RestCase{"longest", {.rest = 1.0}},
                                           RestCase{"horizon", {.horizon = 0.4}},
                                           RestCase{"both", {.rest = 0.3, .horizon = 0.6}}),
                         [](const auto& one) { return one.param.name; });

/// One ball comes to another along a line.
class TemporalCullingTest : public ::testing::Test {
 protected:
  TemporalCullingTest() {
    scene_.addObject({"a", "g", testing::ball(20), 0.05});
    scene_.addObject({"b", "g", testing::ball(20), 0.05});
    scene_.addPair(ObjectId(0), ObjectId(1));
  }
  const Pair& stepAt(double gap) {
    scene_.setPose(ObjectId(1), at(0.4 + gap), t_ += 0.001);
    scene_.step();
    return scene_.pairs()[0];
  }
  Scene scene_;
  double t_{0.0};
};

TEST_F(TemporalCullingTest, QueriesMoreOftenWhenNearer) {
  scene_.setCulling({.rest = 0.1});
  long far = 0, near = 0;
  for (int i = 0; i < 1000; ++i) far += stepAt(2.0 - 0.001 * i).outcome == PairOutcome::kChecked;
  for (int i = 0; i < 880; ++i) near += stepAt(1.0 - 0.001 * i).outcome == PairOutcome::kChecked;
  // A tenth of a clearance of 2 to 1 m, in steps of 1 mm: some 7 checks; of 1 m to nothing: many more.
  EXPECT_LT(far, 15);
  EXPECT_GT(near, 2 * far);
}

TEST_F(TemporalCullingTest, LongestSkipEndsBeforeFirstContact) {
  scene_.setCulling({.rest = 1.0});
  int frame = 0;
  for (; frame < 3000; ++frame) {
    const Pair& pair = stepAt(2.0 - 0.001 * frame);
    ASSERT_EQ(pair.result.contacts, queried(scene_, pair).contacts) << frame;
    if (pair.result.contacts > 0) break;
  }
  EXPECT_LT(frame, 2000) << "the margins touch before the surfaces do";
}

TEST_F(TemporalCullingTest, JitterEndsCullingStandstillDoesNot) {
  scene_.setCulling({.rest = 0.1});
  EXPECT_EQ(stepAt(1.0).outcome, PairOutcome::kChecked);
  long checks = 0;
  for (int i = 0; i < 1000; ++i) checks += stepAt(i % 2 == 0 ? 1.0 : 1.001).outcome == PairOutcome::kChecked;
  EXPECT_GT(checks, 5);
  EXPECT_LT(checks, 20);
  scene_.step();
  EXPECT_TRUE(scene_.updated().empty());
}

TEST_F(TemporalCullingTest, RejectsOutOfRangeOptions) {
  for (const QueryCulling& s :
       {QueryCulling{.rest = -0.1}, QueryCulling{.rest = 1.1}, QueryCulling{.rest = kNaN},
        QueryCulling{.horizon = -1.0}, QueryCulling{.horizon = kNaN}})
    EXPECT_THROW(scene_.setCulling(s), UsageError);
}

TEST_F(TemporalCullingTest, SwitchingOffRestoresExactResults) {
  scene_.setCulling({.rest = 1.0, .horizon = 0.1});
  stepAt(2.0);
  EXPECT_NE(stepAt(1.9).outcome, PairOutcome::kChecked);
  scene_.setCulling({});
  scene_.step();
  EXPECT_TRUE(sameBits(scene_.pairs()[0].result, queried(scene_, scene_.pairs()[0])));
  EXPECT_EQ(stepAt(1.8).outcome, PairOutcome::kChecked);
}

}  // namespace scene_rest_test
}  // namespace abstand::scene
