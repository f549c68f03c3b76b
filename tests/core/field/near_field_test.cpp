// Near and far fields: errors within their bounds, everywhere.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.hpp"
#include "core/field/far_field.hpp"
#include "core/field/near_field.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"

namespace abstand::field {
namespace near_field_test {

using testing::randomPoint;

constexpr float kFloatNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

// Shapes, a mesh of one, and one far from its frame's origin.
std::vector<std::shared_ptr<const geometry::Surface>> bodies() {
  std::vector<std::shared_ptr<const geometry::Surface>> all;
  for (const geometry::Shape& shape : testing::someShapes()) all.push_back(geometry::makeSurface(shape));
  all.push_back(geometry::makeSurface(geometry::tessellate(geometry::Cuboid{{0.2, 0.3, 0.5}}, 0.01)));
  geometry::TriangleMesh far = geometry::tessellate(geometry::Capsule{0.06, 0.3}, 1e-4);
  for (Vector3d& v : far.vertices) v += Vector3d(20.0, -30.0, 10.0);
  all.push_back(geometry::makeSurface(far));
  return all;
}

// Float positions, so that rounding them is not mistaken for an error of the field.
Vector3f probe(const geometry::Surface& surface, std::uint64_t seed, double reach) {
  const geometry::Bounds b = surface.bounds();
  return (b.centre() + randomPoint(seed, 1.0).cwiseProduct((0.5 * b.extent().array() + reach).matrix()))
      .cast<float>();
}

TEST(NearField, ErrorsAreWithinBound) {
  for (const auto& surface : bodies()) {
    const double h = surface->bounds().extent().maxCoeff() / 40.0;
    const VoxelGrid grid = makeGrid(surface->bounds(), h, 6);
    for (const double band : {2.0 * h, 4.0 * h, kInfinity}) {
      const NearField field(*surface, grid, band, 2);
      EXPECT_LT(field.errorBound(), 0.87 * h);
      int inside = 0;
      for (int i = 0; i < 3000; ++i) {
        const Vector3f p = probe(*surface, i, 8.0 * h);
        const double exact = surface->signedDistance(p.cast<double>());
        float sample = 0.0f;
        if (field.sample(p.x(), p.y(), p.z(), sample)) {
          ASSERT_NEAR(sample, exact, field.errorBound());
          ++inside;
        } else {
          // Nothing inside is left out, nor what is within the band.
          ASSERT_GT(exact, field.band());
        }
      }
      EXPECT_GT(inside, 300);
      EXPECT_GT(field.band(), 1.9 * h);
    }
  }
}

TEST(NearField, DeepBlocksHaveNoSamplesAndKeepBound) {
  for (const auto& surface : bodies()) {
    const double h = surface->bounds().extent().maxCoeff() / 150.0;
    const VoxelGrid grid = makeGrid(surface->bounds(), h, 6);
    const NearField whole(*surface, grid, 4.0 * h, 2, std::size_t(1) << 40),
        field(*surface, grid, 4.0 * h, 2, 0);
    ASSERT_FALSE(whole.deep(0.0f, 0.0f, 0.0f));
    EXPECT_EQ(whole.deepErrorBound(), whole.errorBound());
    EXPECT_LT(field.errorBound(), 0.88 * h);
    int deep = 0, near = 0;
    double error = 0.0;
    for (int i = 0; i < 5000; ++i) {
      const Vector3f p = probe(*surface, i, 8.0 * h);
      const double exact = surface->signedDistance(p.cast<double>());
      float sample = 0.0f, expected = 0.0f, same = 0.0f, gradient[3];
      const bool there = field.sample(p.x(), p.y(), p.z(), sample);
      ASSERT_EQ(there, whole.sample(p.x(), p.y(), p.z(), expected)) << "what is outside stays as it was";
      if (!there) continue;
      ASSERT_TRUE(field.sampleGradient(p.x(), p.y(), p.z(), same, gradient));
      ASSERT_EQ(same, sample);
      if (field.deep(p.x(), p.y(), p.z())) {
        ASSERT_LT(exact, -NearField::kInnerBand * h);
        ASSERT_NEAR(sample, exact, field.deepErrorBound());
        error += std::abs(sample - exact);
        ++deep;
      } else {
        ASSERT_NEAR(sample, expected, field.quantum() + whole.quantum());
        ++near;
      }
    }
    EXPECT_GT(near, 100);
    EXPECT_EQ(deep > 0, field.deepErrorBound() > field.errorBound());
    if (deep > 100) {
      EXPECT_LT(field.memoryBytes(), whole.memoryBytes());
      EXPECT_LT(error / deep, 0.35 * field.deepErrorBound()) << "smooth but for ridges";
    }
  }
}

TEST(NearField, ErrorIsSmallNearSmoothSurface) {
  // Within two voxels of a sphere of ten voxels' radius: the second derivative is 1 / r, so the error is
  // about 2 h^2 / (8 r) = h / 40; a quarter of a voxel is far more.
  const geometry::Shape sphere = geometry::Sphere{0.05};
  constexpr double kVoxel = 0.005;
  const auto surface = geometry::makeSurface(sphere);
  const NearField field(*surface, makeGrid(geometry::bounds(sphere), kVoxel, 20), 4.0 * kVoxel, 1);
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3f p = probe(*surface, i, 2.0 * kVoxel);
    const double exact = geometry::distanceTo(sphere, p.cast<double>()).distance;
    float sample = 0.0f;
    if (std::abs(exact) > 2.0 * kVoxel) continue;
    ASSERT_TRUE(field.sample(p.x(), p.y(), p.z(), sample));
    worst = std::max(worst, std::abs(sample - exact));
  }
  RecordProperty("worst_in_voxels", std::to_string(worst / kVoxel));
  EXPECT_LT(worst, 0.25 * kVoxel);
  EXPECT_LT(worst, 0.05 * kVoxel);
}

TEST(NearField, IsExactAtVertices) {
  const auto surface = geometry::makeSurface(geometry::tessellate(geometry::Cylinder{0.05, 0.2}, 1e-3));
  const VoxelGrid grid = makeGrid(surface->bounds(), 0.01, 8);
  const NearField field(*surface, grid, kInfinity, 1);
  for (int i = 0; i < 500; ++i) {
    Vector3i v = ((randomPoint(i, 0.5).array() + 0.5) * grid.size.cast<double>().array()).cast<int>();
    const Vector3d p = grid.centre(v.x(), v.y(), v.z()).array() - 0.5 * grid.voxel_size;
    const Vector3f pf = p.cast<float>();
    float sample = 0.0f;
    if (!field.sample(pf.x(), pf.y(), pf.z(), sample)) continue;  // rounded out of the grid
    // Half a quantum, and float rounding of the coordinates.
    EXPECT_NEAR(sample, surface->signedDistance(p), 0.5 * field.quantum() + 1e-6);
  }
}

TEST(NearField, GradientMatchesSlopeOfSamples) {
  const auto surface = geometry::makeSurface(geometry::Ellipsoid{{0.1, 0.06, 0.08}});
  const NearField field(*surface, makeGrid(surface->bounds(), 0.01, 4), kInfinity, 1);
  constexpr float kStep = 1e-4f;
  for (int i = 0; i < 500; ++i) {
    const Vector3f p = probe(*surface, i, 0.02);
    float d = 0.0f, same = 0.0f, gradient[3];
    ASSERT_TRUE(field.sampleGradient(p.x(), p.y(), p.z(), d, gradient));
    ASSERT_TRUE(field.sample(p.x(), p.y(), p.z(), same));
    EXPECT_EQ(d, same);
    for (int k = 0; k < 3; ++k) {
      const Vector3f a = p - kStep * Vector3f::Unit(k), b = p + kStep * Vector3f::Unit(k);
      float da = 0.0f, db = 0.0f;
      ASSERT_TRUE(field.sample(a.x(), a.y(), a.z(), da) && field.sample(b.x(), b.y(), b.z(), db));
      // Samples have a kink between cells; within one they are straight along an axis but for float rounding.
      const float one_sided = std::max(std::abs(db - d), std::abs(d - da)) / kStep;
      const float least = std::min((db - d) / kStep, (d - da) / kStep),
                  most = std::max((db - d) / kStep, (d - da) / kStep);
      EXPECT_GE(gradient[k], least - 2e-3f) << one_sided;
      EXPECT_LE(gradient[k], most + 2e-3f);
    }
  }
}

TEST(NearField, RejectsInvalidPoints) {
  const auto surface = geometry::makeSurface(geometry::Sphere{0.05});
  const NearField field(*surface, makeGrid(surface->bounds(), 0.005, 4), 0.01, 1);
  const testing::NoAlloc guard;
  for (const float bad :
       {kFloatNaN, kFloatInfinity, -kFloatInfinity, 3e38f, -3e38f, 1e9f, -1e9f, 2147483648.0f}) {
    for (int k = 0; k < 3; ++k) {
      float p[3] = {0.0f, 0.0f, 0.0f}, d = 7.0f, gradient[3];
      p[k] = bad;
      EXPECT_FALSE(field.sample(p[0], p[1], p[2], d));
      EXPECT_FALSE(field.sampleGradient(p[0], p[1], p[2], d, gradient));
      EXPECT_EQ(d, 7.0f);
    }
  }
  float d = 0.0f;
  EXPECT_FALSE(NearField().sample(0.0f, 0.0f, 0.0f, d));
  EXPECT_EQ(guard.count(), 0);
}

TEST(NearField, DoesNotReadBeyondLastBlock) {
  // All around the rim, one float apart.
  const auto surface = geometry::makeSurface(geometry::Cuboid{{0.1, 0.1, 0.1}});
  const VoxelGrid grid = makeGrid(surface->bounds(), 0.00625, 7);
  const NearField field(*surface, grid, kInfinity, 1);
  const int cells = (grid.size.x() + 7) / 8 * 8;
  const float low = static_cast<float>(grid.first_centre.x() - 0.5 * grid.voxel_size);
  float high = static_cast<float>(low + cells * grid.voxel_size), d = 0.0f;
  for (int i = 0; i < 20; ++i) high = std::nextafter(high, -kFloatInfinity);
  int inside = 0;
  for (int i = 0; i < 40; ++i, high = std::nextafter(high, kFloatInfinity))
    inside += field.sample(high, high, high, d);
  EXPECT_GT(inside, 0);
  EXPECT_LT(inside, 40);
}

TEST(NearField, OpenMeshesNeverExceedDistance) {
  geometry::TriangleMesh open = geometry::tessellate(geometry::Sphere{0.05}, 1e-3);
  open.triangles.resize(open.triangles.size() * 3 / 4);
  const auto surface = geometry::makeSurface(open);
  const NearField field(*surface, makeGrid(surface->bounds(), 0.005, 5), 0.02, 1);
  for (int i = 0; i < 5000; ++i) {
    const Vector3f p = probe(*surface, i, 0.02);
    float sample = 0.0f;
    if (!field.sample(p.x(), p.y(), p.z(), sample)) continue;
    ASSERT_LE(std::abs(sample), surface->closest(p.cast<double>()).distance + field.errorBound());
  }
}

TEST(NearField, RejectsTooLargeField) {
  const auto surface = geometry::makeSurface(geometry::Cuboid{{5.0, 5.0, 5.0}});
  EXPECT_THROW(NearField(*surface, makeGrid(surface->bounds(), 0.0045, 0), kInfinity, 1), UsageError);
}

TEST(FarField, IsLowerBoundEverywhere) {
  constexpr int kPoints = 100'000;  // over all bodies
  const auto all = bodies();
  for (const auto& surface : all) {
    const double extent = surface->bounds().extent().maxCoeff(), spacing = extent / 16.0;
    const FarField field(*surface, spacing, 10.0 * extent, 2);
    int breaches = 0, loose = 0;
    for (int i = 0; i < kPoints / int(all.size()); ++i) {
      const Vector3f p = probe(*surface, i, (i % 3 == 0 ? 0.3 : i % 3 == 1 ? 5.0 : 40.0) * extent);
      const double exact = surface->closest(p.cast<double>()).distance;
      const double lower = field.lowerBound(p.x(), p.y(), p.z());
      breaches += lower > exact;
      // As far_field.hpp says, from kMargin spacings on; beyond the last grid the distance to its box is
      // coarser.
      const bool outside =
          (p.cast<double>() - surface->bounds().centre()).cwiseAbs().maxCoeff() < 8.0 * extent;
      loose += outside && exact > FarField::kMargin * spacing && lower < 0.85 * exact;
      ASSERT_GE(lower, 0.0);
    }
    EXPECT_EQ(breaches, 0);
    EXPECT_EQ(loose, 0);
  }
}

TEST(FarField, IsLowerBoundAroundBunny) {
  const auto file = testing::sharedData("meshes/bunny.off");
  if (!exists(file)) GTEST_SKIP() << file;
  const auto surface = geometry::makeSurface(mesh_file::loadMesh(file).mesh);
  const FarField field(*surface, 0.01, 2.0, 2);
  for (int i = 0; i < 20'000; ++i) {
    const Vector3f p = probe(*surface, i, i % 2 == 0 ? 0.1 : 1.0);
    ASSERT_LE(field.lowerBound(p.x(), p.y(), p.z()), surface->closest(p.cast<double>()).distance);
  }
}

TEST(FarField, HandlesAnyInput) {
  const FarField field(*geometry::makeSurface(geometry::Sphere{0.05}), 0.01, 0.5, 1);
  const testing::NoAlloc guard;
  for (const float bad : {kFloatNaN, kFloatInfinity, -kFloatInfinity, 3e38f, -3e38f, 1e9f}) {
    for (int k = 0; k < 3; ++k) {
      float p[3] = {0.0f, 0.0f, 0.0f};
      p[k] = bad;
      const float lower = field.lowerBound(p[0], p[1], p[2]);
      EXPECT_GE(lower, 0.0f);
      EXPECT_TRUE(std::isfinite(lower));
    }
  }
  EXPECT_EQ(field.lowerBound(kFloatNaN, 9.0f, 9.0f), 0.0f);
  EXPECT_EQ(FarField().lowerBound(0.0f, 0.0f, 0.0f), 0.0f);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace near_field_test
}  // namespace abstand::field
