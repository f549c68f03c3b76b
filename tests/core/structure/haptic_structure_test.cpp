// Haptic structures as a whole.
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/state_hash.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/structure/haptic_structure.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/paths.hpp"

namespace abstand::structure {
namespace haptic_structure_test {

using testing::randomPoint;

constexpr FieldKind kKinds[] = {FieldKind::kLayered, FieldKind::kFloat, FieldKind::kMixed};

// All that a query can read.
std::uint64_t hash(const HapticStructure& s) {
  StateHash h;
  if (s.voxelmap) {
    const Vector3i n = s.voxelmap->grid.size;
    for (int k = 0; k < n.z(); ++k)
      for (int j = 0; j < n.y(); ++j)
        for (int i = 0; i < n.x(); ++i) h.add(double(s.voxelmap->at({i, j, k})));
  }
  const geometry::Bounds box = s.surface->bounds();
  for (int i = 0; i < 20'000; ++i) {
    const Vector3f p = (box.centre() + randomPoint(i, 0.8).cwiseProduct(box.extent())).cast<float>();
    float d = -1.0f;
    if (s.near_field && s.near_field->sample(p.x(), p.y(), p.z(), d)) h.add(d);
    h.add(s.far_field.lowerBound(p.x(), p.y(), p.z()));
  }
  for (const auto* v : {&s.tree.x, &s.tree.y, &s.tree.z, &s.tree.nx, &s.tree.ny, &s.tree.nz, &s.tree.area}) {
    for (const float x : *v) h.add(x);
  }
  h.add(s.bounding_sphere.radius);
  h.add(s.errorBound());
  h.add(double(s.surface_voxels));
  h.add(double(s.solid_voxels));
  return h.value();
}

std::shared_ptr<const geometry::Surface> body() {
  return geometry::makeSurface(geometry::tessellate(geometry::Capsule{0.04, 0.08}, 2e-4));
}

TEST(HapticStructure, IsIdenticalForAnyThreadCount) {
  for (const FieldKind kind : kKinds) {
    const HapticOptions options{.voxel_size = 0.008, .point_spacing = 0.01, .outer_layers = 6, .field = kind};
    const std::uint64_t one = hash(*buildHapticStructure("body", body(), options, 1));
    EXPECT_EQ(hash(*buildHapticStructure("body", body(), options, 2)), one);
    EXPECT_EQ(hash(*buildHapticStructure("body", body(), options, 3)), one);
  }
}

TEST(HapticStructure, KeepsDataOfItsFieldKind) {
  const HapticOptions options{.voxel_size = 0.008, .point_spacing = 0.01, .outer_layers = 6};
  const field::Voxelmap map(*body(), options.voxel_size, options.outer_layers, 1);
  std::size_t bytes[3];
  for (const FieldKind kind : kKinds) {
    HapticOptions o = options;
    o.field = kind;
    const auto s = buildHapticStructure("body", body(), o, 1);
    EXPECT_EQ(s->voxelmap.has_value(), kind == FieldKind::kLayered);
    EXPECT_EQ(s->near_field.has_value(), kind != FieldKind::kLayered);
    EXPECT_EQ(s->surface_voxels, map.surface_voxels);
    EXPECT_EQ(s->solid_voxels, map.solid_voxels);
    EXPECT_EQ(s->grid.size, map.grid.size);
    EXPECT_EQ(s->triangles, body()->mesh(0.0).triangles.size());
    EXPECT_GT(s->errorBound(), s->shell.covering_radius);
    EXPECT_LT(s->errorBound(), s->shell.covering_radius + 3.0 * options.voxel_size);
    EXPECT_EQ(s->com, s->mass_properties.com);
    bytes[static_cast<int>(kind)] = s->memoryBytes();
    EXPECT_GT(s->memoryBytes(), 28 * s->shell.size());
  }
  EXPECT_LT(bytes[static_cast<int>(FieldKind::kMixed)], bytes[static_cast<int>(FieldKind::kFloat)]);
}

TEST(HapticStructure, BoundingSphereEnclosesSurface) {
  std::vector<std::shared_ptr<const geometry::Surface>> surfaces{body()};
  for (const geometry::Shape& shape : testing::someShapes()) surfaces.push_back(geometry::makeSurface(shape));
  for (const auto& surface : surfaces) {
    const double size = surface->bounds().extent().maxCoeff();
    const auto s = buildHapticStructure(
        "body", surface, {.voxel_size = size / 20.0, .point_spacing = size / 10.0, .outer_layers = 2}, 2);
    const double reach = s->bounding_sphere.radius;
    double farthest = 0.0;
    for (const Vector3d& v : surface->mesh(1e-3 * size).vertices) {
      farthest = std::max(farthest, (v - s->bounding_sphere.centre).norm());
    }
    EXPECT_LE(farthest, reach * (1.0 + 1e-12));
    EXPECT_GE(farthest, 0.98 * reach);
  }
}

TEST(HapticStructure, ThesisSphereMatches) {
  const auto s = buildHapticStructure("ball", geometry::makeSurface(geometry::Sphere{0.05}),
                                      {.field = FieldKind::kLayered}, 2);
  EXPECT_EQ(s->grid.cells(), 226'981u);
  // Along the diagonal the surface is 10 / sqrt(3) voxels from the middle: in the sixth.
  EXPECT_EQ(s->voxelmap->at({30, 30, 30}), 6);
  EXPECT_EQ(s->voxelmap->at({0, 0, 0}), -24);
  EXPECT_NEAR(s->bounding_sphere.radius, 0.05, 1e-15);
}

TEST(HapticStructure, RejectsOutOfRangeOptions) {
  const auto surface = body();
  for (const HapticOptions& bad :
       {HapticOptions{.voxel_size = 0.0}, HapticOptions{.voxel_size = kNaN},
        HapticOptions{.voxel_size = kInfinity}, HapticOptions{.point_spacing = -1.0},
        HapticOptions{.outer_layers = -1}, HapticOptions{.outer_layers = 1 << 30},
        HapticOptions{.voxel_size = 1e-5}}) {
    EXPECT_THROW(buildHapticStructure("body", surface, bad, 1), UsageError);
  }
}

TEST(FieldKind, NamesRoundTrip) {
  for (const FieldKind kind : kKinds) EXPECT_EQ(parseFieldKind(fieldName(kind)), kind);
  EXPECT_EQ(parseFieldKind("flt"), std::nullopt);
}

TEST(HapticStructure, HandlesUnsoundMeshes) {
  for (const char* name :
       {"not_convex.obj", "halftunnel.off", "featuretype.STL", "multibody.stl", "2triangles.off"}) {
    const auto file = testing::sharedData(std::string("meshes/") + name);
    if (!exists(file)) GTEST_SKIP() << file;
    const std::shared_ptr<const geometry::Surface> surface =
        geometry::makeSurface(mesh_file::loadMesh(file).mesh);
    const double h = surface->bounds().extent().maxCoeff() / 40.0;
    const auto s = buildHapticStructure(name, surface,
                                        {.voxel_size = h, .point_spacing = 2.0 * h, .outer_layers = 4}, 2);
    EXPECT_GT(s->surface_voxels, 0u) << name;
    EXPECT_TRUE(s->com.allFinite()) << name;
    const geometry::Bounds box = surface->bounds();
    for (int i = 0; i < 2000; ++i) {
      const Vector3f p = (box.centre() + randomPoint(i, 0.7).cwiseProduct(box.extent())).cast<float>();
      const double exact = surface->closest(p.cast<double>()).distance;
      float d = 0.0f;
      if (s->near_field->sample(p.x(), p.y(), p.z(), d)) {
        ASSERT_LE(std::abs(d), exact + s->near_field->errorBound());
      }
      ASSERT_LE(s->far_field.lowerBound(p.x(), p.y(), p.z()), exact);
    }
  }
}

}  // namespace haptic_structure_test
}  // namespace abstand::structure
