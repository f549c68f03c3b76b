// Pairs asked together answer as each of them does alone.
#include "core/query/pair_set.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::testing {
namespace pair_set_test {

/// m; a walk ends when a round gains less than 0.1 % of the distance, here up to 0.1 m (witness.hpp).
constexpr double kSameDistance = 1e-4;
/// m; a tenth of the spacing. Inside, a search that sums contacts on its way starts its walk from the point
/// that the field says is the deepest, another one from the first that none can exceed by more than the
/// field's error: near a medial axis the walks end that much apart.
constexpr double kSameDepth = 4e-4;
/// m; contacts deeper than that are never missed.
constexpr double kShallow = 1e-4;
constexpr int kFrames = 400;

/// Five bodies that turn and pass close by, and through, each other. `jumps`: two of them turn over now and
/// then, as an elbow that a tracker sees badly.
class Crowd {
 public:
  explicit Crowd(bool jumps = false) : jumps_(jumps) {
    for (const geometry::Shape& shape :
         {geometry::Shape(geometry::Sphere{0.05}), geometry::Shape(geometry::Cuboid{{0.1, 0.12, 0.3}}),
          geometry::Shape(geometry::Ellipsoid{{0.04, 0.05, 0.12}}),
          geometry::Shape(geometry::Capsule{0.04, 0.15}), geometry::Shape(geometry::Cylinder{0.05, 0.2})})
      bodies.push_back(&structureOf(shape, structure::FieldKind::kMixed));
    for (std::uint32_t a = 0; a < bodies.size(); ++a)
      for (std::uint32_t b = a + 1; b < bodies.size(); ++b) pairs.push_back({a, b});
    X_WB.resize(bodies.size());
  }
  void move(int frame) {
    for (std::size_t i = 0; i < X_WB.size(); ++i) {
      const double t = 0.004 * frame * (1.0 + 0.3 * static_cast<double>(i));
      const Transform start = randomPose(i);
      const Vector3d about(0.22 * std::sin(t + double(i)), 0.2 * std::cos(1.3 * t + 2.0 * double(i)),
                           0.1 * std::sin(2.1 * t));
      X_WB[i] = Eigen::Translation3d(about) * Eigen::AngleAxisd(2.0 * t, start.linear().col(0)) *
                Transform(start.linear());
      if (jumps_ && i % 2 == 1 && random_() % 2 == 0)
        X_WB[i] = X_WB[i] * Eigen::Translation3d(0.06, 0.0, 0.0) *
                  Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX());
    }
  }
  std::vector<const structure::HapticStructure*> bodies;
  std::vector<query::PairSet::Bodies> pairs;
  std::vector<Transform> X_WB;

 private:
  bool jumps_;
  std::mt19937 random_{5};
};

query::PairResult alone(const Crowd& crowd, std::size_t pair, const query::PairOptions& options) {
  kernels::PairScratch scratch;
  query::PairResult result;
  const auto [a, b] = crowd.pairs[pair];
  query::queryPair({*crowd.bodies[a], crowd.X_WB[a]}, {*crowd.bodies[b], crowd.X_WB[b]}, options, scratch,
                   result);
  return result;
}

TEST(PairSet, FindsNearestPair) {
  for (const bool jumps : {false, true}) {
    Crowd crowd(jumps);
    query::PairSet set(crowd.bodies, crowd.pairs);
    int apart = 0, inside = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      crowd.move(frame);
      double least = kInfinity;
      for (std::size_t i = 0; i < set.size(); ++i) least = std::min(least, alone(crowd, i, {}).distance);
      const query::PairSet::Nearest& nearest = set.nearest(crowd.X_WB, {});
      // A walk from elsewhere may end nearer, within the bound of the one that did not.
      const query::PairResult same = alone(crowd, nearest.pair, {});
      ASSERT_LE(nearest.result.distance, least + (least > 0.0 ? kSameDistance : kSameDepth)) << frame;
      ASSERT_GE(nearest.result.distance, same.distance - same.bound - kSameDistance) << frame;
      ASSERT_LE(same.distance - same.bound, least + kSameDistance) << frame;
      ++(least > 0.0 ? apart : inside);
    }
    EXPECT_GT(apart, kFrames / 20);
    EXPECT_GT(inside, kFrames / 20);
  }
}

TEST(PairSet, FindsExactlyAllContacts) {
  for (const auto& [margin, jumps] : {std::pair(0.0, false), {0.03, false}, {0.0, true}, {0.03, true}}) {
    Crowd crowd(jumps);
    query::PairSet set(crowd.bodies, crowd.pairs);
    const query::PairOptions options{.margin = margin};
    int touching = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      crowd.move(frame);
      const auto touches = set.contacts(crowd.X_WB, options);
      auto touch = touches.begin();
      for (std::size_t i = 0; i < set.size(); ++i) {
        const query::PairResult each = alone(crowd, i, options);
        const bool found = touch != touches.end() && touch->pair == i;
        if (found) {
          ASSERT_LT(each.distance, margin + kShallow) << frame;
          ASSERT_EQ(touch->penalty.contacts, each.contacts);
          ASSERT_EQ(touch->penalty.force_a, each.force_a);
          ASSERT_EQ(touch->penalty.torque_a, each.torque_a);
          ASSERT_EQ(touch->penalty.torque_b, each.torque_b);
          ++touch;
          ++touching;
        } else {
          ASSERT_GT(each.distance, margin - kShallow) << frame;
          ASSERT_EQ(each.contacts, 0);
        }
      }
      ASSERT_EQ(touch, touches.end());
    }
    EXPECT_GT(touching, kFrames / 10);
  }
}

TEST(PairSet, AllocatesNothing) {
  Crowd crowd;
  query::PairSet set(crowd.bodies, crowd.pairs);
  std::vector<query::PairResult> results(set.size());
  crowd.move(0);
  const NoAlloc guard;
  for (int frame = 0; frame < 50; ++frame) {
    crowd.move(frame);
    set.distances(crowd.X_WB, {}, results);
    set.contacts(crowd.X_WB, {});
    set.nearest(crowd.X_WB, {});
  }
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace pair_set_test
}  // namespace abstand::testing
