// The searches for machines with and without AVX2 give the same bits.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "core/kernels/search_kernels.hpp"
#include "core/math/random.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/structures.hpp"

namespace abstand::testing {
namespace search_kernels_test {

/// m; rounding of a sample in float.
constexpr float kRounding = 1e-5f;
constexpr structure::FieldKind kKinds[] = {structure::FieldKind::kMixed, structure::FieldKind::kFloat,
                                           structure::FieldKind::kLayered};

std::uint32_t bitsOf(float x) { return std::isnan(x) ? 0xffffffffu : std::bit_cast<std::uint32_t>(x); }
std::uint64_t bitsOf(double x) { return std::isnan(x) ? ~0ull : std::bit_cast<std::uint64_t>(x); }

void expectSame(const kernels::NearestPoint& a, const kernels::NearestPoint& b) {
  ASSERT_EQ(bitsOf(a.lower_bound), bitsOf(b.lower_bound)) << a.lower_bound - b.lower_bound;
  ASSERT_EQ(bitsOf(a.estimate), bitsOf(b.estimate)) << a.estimate - b.estimate;
  ASSERT_EQ(a.point, b.point);
}

void expectSame(const kernels::ContactSum& a, const kernels::ContactSum& b) {
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(bitsOf(a.force[k]), bitsOf(b.force[k])) << a.force[k] - b.force[k];
    ASSERT_EQ(bitsOf(a.moment[k]), bitsOf(b.moment[k])) << a.moment[k] - b.moment[k];
  }
  ASSERT_EQ(a.contacts, b.contacts);
  ASSERT_EQ(bitsOf(a.depth), bitsOf(b.depth)) << a.depth - b.depth;
  ASSERT_EQ(a.nearest, b.nearest);
}

/// A field whose inside carries no samples, as those of fine maps.
structure::HapticStructure withDeepBlocks(const structure::HapticStructure& whole) {
  structure::HapticStructure s = whole;
  s.near_field.emplace(*s.surface, s.grid, 4.0 * s.options.voxel_size, 1, 0);
  EXPECT_GT(s.near_field->deepErrorBound(), s.near_field->errorBound());
  return s;
}

/// Bodies that are turned and moved at random, apart and inside of each other, a few of them without a sane
/// pose.
TEST(SearchKernels, VectorKernelsAreBitIdenticalForPoses) {
  const kernels::SearchKernels &fast = kernels::searchKernels(), &plain = kernels::kPortableKernels;
  if (&fast == &plain) GTEST_SKIP() << "this machine runs the portable ones";
  const structure::HapticStructure deep =
      withDeepBlocks(structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, structure::FieldKind::kMixed));
  for (int kind = 0; kind < 4; ++kind) {
    const auto& P = structureOf(geometry::Ellipsoid{{0.04, 0.05, 0.12}}, structure::FieldKind::kMixed);
    const auto& F = kind == 3 ? deep : structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, kKinds[kind]);
    const kernels::FieldView field = F.fieldView();
    kernels::PairScratch scratch;
    int touching = 0, apart = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      SCOPED_TRACE(seed);
      Transform X_FP = randomPose(seed, seed % 3 == 0 ? 0.1 : seed % 3 == 1 ? 0.6 : 5.0);
      // Faces in line with voxels, where every comparison is a tie.
      if (seed % 10 == 5) X_FP.linear().setIdentity();
      if (seed == 20) X_FP.translation().x() = kNaN;
      if (seed == 21) X_FP.translation().y() = kInfinity;
      if (seed == 22) X_FP.linear() *= 0.0;
      const kernels::TreeView tree = P.treeView(X_FP);
      for (const kernels::NearestLimits& limits :
           {kernels::NearestLimits{std::numeric_limits<float>::infinity(), 0.1f, 0.0f},
            kernels::NearestLimits{0.2f, 0.1f, 0.01f}})
        expectSame(fast.nearest(tree, field, limits, scratch), plain.nearest(tree, field, limits, scratch));
      for (const kernels::ContactLimits& limits :
           {kernels::ContactLimits{0.02f, 0.02f, true}, kernels::ContactLimits{0.0f, 0.03f, false}}) {
        const kernels::ContactSum sum = fast.contacts(tree, field, limits, scratch);
        expectSame(sum, plain.contacts(tree, field, limits, scratch));
        const kernels::ContactSearch a = fast.contactSearch(tree, field, limits, scratch),
                                     b = plain.contactSearch(tree, field, limits, scratch);
        expectSame(a.sum, b.sum);
        expectSame(a.nearest, b.nearest);
        touching += sum.contacts > 0;
        apart += sum.contacts == 0;
      }
      const Vector3f c = (X_FP * P.tree.at(static_cast<std::uint32_t>(seed) % P.tree.x.size())).cast<float>();
      const kernels::Ball ball{{c.x(), c.y(), c.z()}, 0.03f};
      ASSERT_EQ(bitsOf(fast.nearestOutside(tree, field, ball, 1.0f, scratch)),
                bitsOf(plain.nearestOutside(tree, field, ball, 1.0f, scratch)));
      ASSERT_EQ(fast.meeting(tree.X_FP, P.parts.spheres(), F.parts.spheres(), F.parts.size(), 0.02f),
                plain.meeting(tree.X_FP, P.parts.spheres(), F.parts.spheres(), F.parts.size(), 0.02f));
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(touching, 100);
    EXPECT_GT(apart, 100);
  }
}

/// Any floats: of all sizes, zeros of both signs, infinities and NaN.
TEST(SearchKernels, VectorKernelsAreBitIdenticalForAnyFloats) {
  const kernels::SearchKernels &fast = kernels::searchKernels(), &plain = kernels::kPortableKernels;
  if (&fast == &plain) GTEST_SKIP() << "this machine runs the portable ones";
  Random random(7, 0);
  const auto any = [&](bool special) {
    const auto word = static_cast<std::uint32_t>(random.bits() >> 32);
    if (special && word % 5 == 0) return word % 2 == 0 ? 0.0f : -0.0f;
    if (special && word % 97 == 0) return std::numeric_limits<float>::quiet_NaN();
    if (special && word % 101 == 0) return -std::numeric_limits<float>::infinity();
    return std::ldexp(static_cast<float>(random.unit() - 0.5), static_cast<int>(word % 60) - 40);
  };
  for (int round = 0; round < 2000; ++round) {
    const bool special = round % 2 == 1;
    const std::size_t count = 8u * (1u + static_cast<std::size_t>(round) % 5u);
    std::vector<float> x(count), y(count), z(count);
    for (auto* v : {&x, &y, &z})
      for (float& value : *v) value = any(special);
    const float g[3] = {any(special), any(special), any(special)};
    ASSERT_EQ(bitsOf(fast.support({x.data(), y.data(), z.data(), count}, g[0], g[1], g[2])),
              bitsOf(plain.support({x.data(), y.data(), z.data(), count}, g[0], g[1], g[2])))
        << round;
    ASSERT_EQ(fast.extreme({x.data(), y.data(), z.data(), count}, g[0], g[1], g[2]),
              plain.extreme({x.data(), y.data(), z.data(), count}, g[0], g[1], g[2]))
        << round;
    kernels::SphereGroup P, F;
    float X_FP[12];
    for (float& value : X_FP) value = any(special);
    for (auto* spheres : {&P, &F})
      for (auto* v : {spheres->x, spheres->y, spheres->z, spheres->radius})
        for (std::size_t i = 0; i < structure::SurfaceParts::kMax; ++i) v[i] = any(special);
    const float by = any(special);
    ASSERT_EQ(fast.meeting(X_FP, P, F, 8, by), plain.meeting(X_FP, P, F, 8, by)) << round;
  }
}

/// What they say is right: the point without contacts that is the nearest by its sample, and what is outside
/// of a ball.
TEST(SearchKernels, FindNearestPoint) {
  for (const structure::FieldKind kind : {structure::FieldKind::kMixed, structure::FieldKind::kFloat}) {
    const auto& P = structureOf(geometry::Ellipsoid{{0.04, 0.05, 0.12}}, kind);
    const auto& F = structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, kind);
    const kernels::FieldView field = F.fieldView();
    const kernels::SearchKernels& kernels = kernels::searchKernels();
    kernels::PairScratch scratch;
    int watched = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const Transform X_FP = randomPose(seed, seed % 3 == 0 ? 0.1 : 0.6);
      const kernels::TreeView tree = P.treeView(X_FP);
      constexpr float kWatch = 0.03f;
      const kernels::ContactSum w = kernels.contacts(tree, field, {0.0f, kWatch, true}, scratch);
      const auto sampleAt = [&](std::uint32_t point) {
        const Vector3f p = (X_FP * P.tree.at(point)).cast<float>();
        float sample;
        return F.near_field->sample(p.x(), p.y(), p.z(), sample) ? sample
                                                                 : std::numeric_limits<float>::infinity();
      };
      float least = std::numeric_limits<float>::infinity();
      for (std::uint32_t k = 0; k < P.tree.x.size(); ++k) least = std::min(least, sampleAt(k));
      if (least < -kRounding || least > kWatch + kRounding) {
        EXPECT_EQ(w.nearest, kernels::kNoPoint) << seed;
      } else if (least > kRounding && least < kWatch - kRounding) {
        ASSERT_NE(w.nearest, kernels::kNoPoint) << seed;
        EXPECT_NEAR(sampleAt(w.nearest), least, kRounding) << seed;
        ++watched;
      }
      // Points about the nearest one left out.
      const kernels::NearestPoint a =
          kernels.nearest(tree, field, {std::numeric_limits<float>::infinity(), 0.1f, 0.0f}, scratch);
      const Vector3d home = X_FP * P.tree.at(a.point);
      const kernels::Ball ball{{float(home.x()), float(home.y()), float(home.z())}, 0.03f};
      ASSERT_GE(kernels.nearestOutside(tree, field, ball, 1.0f, scratch), a.lower_bound - kRounding);
    }
    EXPECT_GT(watched, 5);
  }
}

/// Where the inside carries no samples, spheres are left out by bounds of their own: no point within the
/// margin is lost, and what is said to be proven is.
TEST(SearchKernels, LoseNoPointsInDeepBlocks) {
  const auto& P = structureOf(geometry::Ellipsoid{{0.04, 0.05, 0.12}}, structure::FieldKind::kMixed);
  const structure::HapticStructure F =
      withDeepBlocks(structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, structure::FieldKind::kMixed));
  const kernels::FieldView field = F.fieldView();
  kernels::PairScratch scratch;
  int deepest = 0;
  for (const kernels::SearchKernels* kernels : {&kernels::searchKernels(), &kernels::kPortableKernels}) {
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      const Transform X_FP = randomPose(seed, seed % 2 == 0 ? 0.05 : 0.2);
      const kernels::TreeView tree = P.treeView(X_FP);
      for (const float margin : {-0.03f, 0.0f, 0.01f}) {
        const kernels::ContactSum sum = kernels->contacts(tree, field, {margin, margin, true}, scratch);
        int least = 0, most = 0;
        double nearest = kInfinity;
        for (std::uint32_t i = 0; i < P.tree.x.size(); ++i) {
          const Vector3d p = X_FP * P.tree.at(i);
          nearest = std::min(nearest, F.surface->signedDistance(p));
          const Vector3f q = p.cast<float>();
          float s;
          if (P.tree.area[i] <= 0.0f || !F.near_field->sample(q.x(), q.y(), q.z(), s)) continue;
          least += s < margin - kRounding;
          most += s < margin + kRounding;
          deepest += F.near_field->deep(q.x(), q.y(), q.z());
        }
        ASSERT_GE(sum.contacts, least) << seed << ", margin " << margin;
        ASSERT_LE(sum.contacts, most) << seed << ", margin " << margin;
        const kernels::NearestPoint found =
            kernels->nearest(tree, field, {std::numeric_limits<float>::infinity(), 0.1f, 0.0f}, scratch);
        ASSERT_LE(found.lower_bound, nearest + kRounding) << seed;
        const kernels::ContactSearch both =
            kernels->contactSearch(tree, field, {margin, margin + 0.01f, true}, scratch);
        ASSERT_EQ(both.sum.contacts, sum.contacts) << seed;
        ASSERT_LE(both.nearest.lower_bound, nearest + kRounding) << seed;
      }
    }
  }
  EXPECT_GT(deepest, 10'000);
}

/// The search that sums on its way sums the same, and what it says of the nearest point holds for the exact
/// surface.
TEST(SearchKernels, CombinedSearchMatchesSumAndSearch) {
  constexpr float kMargin = 0.01f, kWatch = 0.02f;
  for (const structure::FieldKind kind : kKinds) {
    const auto& P = structureOf(geometry::Ellipsoid{{0.04, 0.05, 0.12}}, kind);
    const auto& F = structureOf(geometry::Cuboid{{0.1, 0.12, 0.3}}, kind);
    const kernels::FieldView field = F.fieldView();
    kernels::PairScratch scratch;
    for (const kernels::SearchKernels* kernels : {&kernels::searchKernels(), &kernels::kPortableKernels}) {
      int touching = 0, near = 0;
      for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Transform X_FP = randomPose(seed, seed % 3 == 0 ? 0.1 : 0.3);
        const kernels::TreeView tree = P.treeView(X_FP);
        const kernels::ContactSum sum = kernels->contacts(tree, field, {kMargin, kMargin, true}, scratch);
        const kernels::ContactSearch both =
            kernels->contactSearch(tree, field, {kMargin, kWatch, true}, scratch);
        ASSERT_EQ(both.sum.contacts, sum.contacts) << seed;
        ASSERT_EQ(both.sum.depth, sum.depth) << seed;
        for (int k = 0; k < 3; ++k) {
          ASSERT_EQ(both.sum.force[k], sum.force[k]) << seed;
          ASSERT_EQ(both.sum.moment[k], sum.moment[k]) << seed;
        }
        double least = kInfinity;
        for (std::uint32_t i = 0; i < P.tree.x.size(); ++i)
          least = std::min(least, F.surface->signedDistance(X_FP * P.tree.at(i)));
        ASSERT_LE(both.nearest.lower_bound, least + kRounding) << seed;
        if (both.nearest.point != kernels::kNoPoint) {
          ASSERT_LE(both.nearest.estimate, kWatch);
          ++near;
        } else {
          ASSERT_EQ(sum.contacts, 0) << seed;
        }
        if (sum.contacts > 0 && kind != structure::FieldKind::kLayered) {
          ASSERT_NEAR(both.nearest.estimate, kMargin - sum.depth, kRounding) << seed;
        }
        touching += sum.contacts > 0;
      }
      EXPECT_GT(touching, 30);
      EXPECT_GT(near, touching);
    }
  }
}

TEST(SearchKernels, SupportIsLargestProduct) {
  std::vector<float> x, y, z;
  for (std::uint64_t i = 0; i < 64; ++i) {
    const Vector3f p = randomPose(i).translation().cast<float>();
    x.push_back(p.x()), y.push_back(p.y()), z.push_back(p.z());
  }
  for (const kernels::SearchKernels* kernels : {&kernels::searchKernels(), &kernels::kPortableKernels}) {
    float most = -1e30f;
    for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, 0.3f * x[i] - 0.7f * y[i] + 0.2f * z[i]);
    EXPECT_NEAR(kernels->support({x.data(), y.data(), z.data(), x.size()}, 0.3f, -0.7f, 0.2f), most, 1e-6f);
    const std::size_t i = kernels->extreme({x.data(), y.data(), z.data(), x.size()}, 0.3f, -0.7f, 0.2f);
    ASSERT_LT(i, x.size());
    EXPECT_NEAR(0.3f * x[i] - 0.7f * y[i] + 0.2f * z[i], most, 1e-6f);
  }
}

}  // namespace search_kernels_test
}  // namespace abstand::testing
