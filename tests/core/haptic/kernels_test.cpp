// The searches for machines with and without AVX2 say the same, but for rounding.
#include <gtest/gtest.h>

#include "core/haptic/search_kernels.hpp"
#include "tests/core/haptic/structures.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::testing {
namespace {

/// m; a fused multiply-add rounds once where two instructions round twice.
constexpr float kRounding = 1e-5f;

TEST(SearchKernels, AgreeOnEveryMachine) {
  const SearchKernels &fast = searchKernels(), &plain = kPortableKernels;
  if (&fast == &plain) GTEST_SKIP() << "this machine runs the portable ones";
  for (const FieldKind kind : {FieldKind::kMixed, FieldKind::kFloat, FieldKind::kLayered}) {
    const auto& P = structureOf(Ellipsoid{{0.04, 0.05, 0.12}}, kind);
    const auto& F = structureOf(Cuboid{{0.1, 0.12, 0.3}}, kind);
    const FieldView field = F.fieldView();
    PairScratch scratch;
    int touching = 0, watched = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const Transform X_FP = randomPose(seed, seed % 3 == 0 ? 0.1 : 0.6);
      const TreeView tree = P.treeView(X_FP);
      const NearestLimits limits{std::numeric_limits<float>::infinity(), 0.1f, 0.0f};
      const NearestPoint a = fast.nearest(tree, field, limits, scratch),
                         b = plain.nearest(tree, field, limits, scratch);
      ASSERT_NEAR(a.lower_bound, b.lower_bound, kRounding) << seed;
      // Where two voxels of a layered map meet, rounding decides which one a point lies in.
      if (kind == FieldKind::kLayered) continue;
      ASSERT_NEAR(a.estimate, b.estimate, kRounding) << seed;
      const ContactSum s = fast.contacts(tree, field, {0.02f, 0.02f, true}, scratch),
                       t = plain.contacts(tree, field, {0.02f, 0.02f, true}, scratch);
      ASSERT_NEAR(s.depth, t.depth, kRounding);
      for (int k = 0; k < 3; ++k) {
        // Relative to some cm^2 pressed by some cm.
        ASSERT_NEAR(s.force[k], t.force[k], 1e-8);
        ASSERT_NEAR(s.moment[k], t.moment[k], 1e-8);
      }
      touching += s.contacts > 0;
      // Without contacts, the point that is the nearest by its sample is told, when that is watched.
      constexpr float kWatch = 0.03f;
      const ContactSum w = fast.contacts(tree, field, {0.0f, kWatch, true}, scratch);
      const auto sampleAt = [&](std::uint32_t point) {
        const Vector3f p = (X_FP * P.tree.at(point)).cast<float>();
        float sample;
        return F.near_field->sample(p.x(), p.y(), p.z(), sample) ? sample
                                                                 : std::numeric_limits<float>::infinity();
      };
      float least = std::numeric_limits<float>::infinity();
      for (std::uint32_t k = 0; k < P.tree.x.size(); ++k) least = std::min(least, sampleAt(k));
      if (least < -kRounding || least > kWatch + kRounding) {
        EXPECT_EQ(w.nearest, kNoPoint) << seed;
      } else if (least > kRounding && least < kWatch - kRounding) {
        ASSERT_NE(w.nearest, kNoPoint) << seed;
        EXPECT_NEAR(sampleAt(w.nearest), least, kRounding) << seed;
        ++watched;
      }
      // Points about the nearest one left out.
      const std::uint32_t i = a.point;
      const Vector3d home = X_FP * P.tree.at(i);
      const Ball ball{{float(home.x()), float(home.y()), float(home.z())}, 0.03f};
      const float rival = fast.nearestOutside(tree, field, ball, 1.0f, scratch);
      ASSERT_NEAR(rival, plain.nearestOutside(tree, field, ball, 1.0f, scratch), kRounding) << seed;
      ASSERT_GE(rival, a.lower_bound - kRounding);
    }
    if (kind != FieldKind::kLayered) {
      EXPECT_GT(touching, 50);
      EXPECT_GT(watched, 5);
    }
  }
}

/// The search that sums on its way sums the same, and what it says of the nearest point holds for the exact
/// surface.
TEST(SearchKernels, SearchWhileTheySum) {
  constexpr float kMargin = 0.01f, kWatch = 0.02f;
  for (const FieldKind kind : {FieldKind::kMixed, FieldKind::kFloat, FieldKind::kLayered}) {
    const auto& P = structureOf(Ellipsoid{{0.04, 0.05, 0.12}}, kind);
    const auto& F = structureOf(Cuboid{{0.1, 0.12, 0.3}}, kind);
    const FieldView field = F.fieldView();
    PairScratch scratch;
    for (const SearchKernels* kernels : {&searchKernels(), &kPortableKernels}) {
      int touching = 0, near = 0;
      for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Transform X_FP = randomPose(seed, seed % 3 == 0 ? 0.1 : 0.3);
        const TreeView tree = P.treeView(X_FP);
        const ContactSum sum = kernels->contacts(tree, field, {kMargin, kMargin, true}, scratch);
        const ContactSearch both = kernels->contactSearch(tree, field, {kMargin, kWatch, true}, scratch);
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
        if (both.nearest.point != kNoPoint) {
          ASSERT_LE(both.nearest.estimate, kWatch);
          ++near;
        } else {
          ASSERT_EQ(sum.contacts, 0) << seed;
        }
        if (sum.contacts > 0 && kind != FieldKind::kLayered) {
          ASSERT_NEAR(both.nearest.estimate, kMargin - sum.depth, kRounding) << seed;
        }
        touching += sum.contacts > 0;
      }
      EXPECT_GT(touching, 30);
      EXPECT_GT(near, touching);
    }
  }
}

TEST(SearchKernels, SupportIsTheLargestProduct) {
  std::vector<float> x, y, z;
  for (std::uint64_t i = 0; i < 64; ++i) {
    const Vector3f p = randomPose(i).translation().cast<float>();
    x.push_back(p.x()), y.push_back(p.y()), z.push_back(p.z());
  }
  for (const SearchKernels* kernels : {&searchKernels(), &kPortableKernels}) {
    float most = -1e30f;
    for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, 0.3f * x[i] - 0.7f * y[i] + 0.2f * z[i]);
    EXPECT_NEAR(kernels->support(x.data(), y.data(), z.data(), x.size(), 0.3f, -0.7f, 0.2f), most, 1e-6f);
    const std::size_t i = kernels->extreme(x.data(), y.data(), z.data(), x.size(), 0.3f, -0.7f, 0.2f);
    ASSERT_LT(i, x.size());
    EXPECT_NEAR(0.3f * x[i] - 0.7f * y[i] + 0.2f * z[i], most, 1e-6f);
  }
}

}  // namespace
}  // namespace abstand::testing
