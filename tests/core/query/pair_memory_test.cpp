// What a pair remembers makes it faster, and changes nothing beyond what is allowed.
#include <gtest/gtest.h>

#include <random>

#include "core/math/roll_pitch_yaw.hpp"
#include "core/query/pair_query.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::testing {
namespace pair_memory_test {

/// Two answers for one pose, the first of them from memory.
void expectAgree(const query::PairResult& warm, const query::PairResult& cold, int frame) {
  ASSERT_GE(warm.bound, 0.0);
  ASSERT_LE(warm.distance - warm.bound, cold.distance + 1e-9) << frame;
  ASSERT_LE(cold.distance - cold.bound, warm.distance + 1e-9) << frame;
  if (warm.distance > 0.0) {
    ASSERT_LE(std::abs(warm.distance - cold.distance), warm.distance > 0.1 ? 0.01 * warm.distance : 1e-3)
        << frame;
  }
  ASSERT_EQ(warm.contacts, cold.contacts) << frame;
  ASSERT_EQ(warm.force_a, cold.force_a) << frame;
}

/// A box along a path of small steps and sudden turns past another.
TEST(PairMemory, WarmStartMatchesColdStartWithinBounds) {
  for (const structure::FieldKind field : {structure::FieldKind::kMixed, structure::FieldKind::kLayered}) {
    const auto& a = structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, field);
    const auto& b = structureOf(geometry::Cylinder{0.05, 0.2}, field);
    query::PairMemory memory;
    kernels::PairScratch scratch;
    query::PairResult warm, cold;
    int proven = 0;
    for (int frame = 0; frame < 2000; ++frame) {
      const Transform X_WB = fromXyzRpy({0.5 * std::cos(0.003 * frame), 0.3 * std::sin(0.005 * frame), 0.05},
                                        {0.002 * frame, 0.001 * frame, frame % 500 == 0 ? 3.0 : 0.0});
      query::queryPair({a, Transform::Identity()}, {b, X_WB}, {.margin = 0.05}, {memory, scratch}, warm);
      query::queryPair({a, Transform::Identity()}, {b, X_WB}, {.margin = 0.05}, scratch, cold);
      ASSERT_NO_FATAL_FAILURE(expectAgree(warm, cold, frame));
      proven += warm.distance > 0.0 && warm.bound < 0.011 * warm.distance;
    }
    EXPECT_GT(proven, 1000) << "slabs prove most of them";
  }
}

/// A body of which a tracker cannot tell on which of two ways it goes.
TEST(PairMemory, AlternatingPosesKeepBounds) {
  const auto& a = structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, structure::FieldKind::kMixed);
  const auto& b = structureOf(geometry::Capsule{0.04, 0.15}, structure::FieldKind::kMixed);
  kernels::PairScratch scratch;
  query::PairResult warm, cold;
  for (const double margin : {0.0, 0.02}) {
    query::PairMemory memory;
    std::mt19937 random(7);
    int touching = 0;
    for (int frame = 0; frame < 2000; ++frame) {
      const double t = 0.002 * frame, aside = random() % 2 == 0 ? 0.1 : -0.15;
      const Transform X_WB =
          fromXyzRpy({0.25 * std::cos(t), aside, 0.2 * std::sin(2.0 * t)}, {t, 10.0 * aside, 0.5 * t});
      query::queryPair({a, Transform::Identity()}, {b, X_WB}, {.margin = margin}, {memory, scratch}, warm);
      query::queryPair({a, Transform::Identity()}, {b, X_WB}, {.margin = margin}, scratch, cold);
      ASSERT_NO_FATAL_FAILURE(expectAgree(warm, cold, frame));
      touching += warm.distance < 0.0;
    }
    EXPECT_GT(touching, 50);
  }
}

/// Of the points of two parallel faces, all as near, it takes those that it knew there, although others are
/// where a search from elsewhere ends.
TEST(PairMemory, ReturningBodyFindsFormerWitness) {
  const auto& box = structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, structure::FieldKind::kMixed);
  const Transform X_WA = Transform::Identity(), X_WB = fromXyzRpy({0.3, 0.01, 0.02}, {0.0, 0.0, 0.0}),
                  X_WB_jumped = fromXyzRpy({0.02, 0.35, 0.0}, {0.0, 0.0, 1.6});
  query::PairMemory memory;
  kernels::PairScratch scratch;
  query::PairResult before, between, after;
  query::queryPair({box, X_WA}, {box, X_WB}, {}, {memory, scratch}, before);
  query::queryPair({box, X_WA}, {box, X_WB_jumped}, {}, {memory, scratch}, between);
  ASSERT_GT(std::abs(between.distance - before.distance), 0.01);
  query::queryPair({box, X_WA}, {box, X_WB}, {}, {memory, scratch}, after);
  EXPECT_LT((after.witness_a - before.witness_a).norm(), 1e-12);
  EXPECT_LT((after.witness_b - before.witness_b).norm(), 1e-12);
  EXPECT_NEAR(after.distance, before.distance, 1e-12);
}

}  // namespace pair_memory_test
}  // namespace abstand::testing
