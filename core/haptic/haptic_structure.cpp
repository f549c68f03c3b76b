// Builds everything the collision engine knows of one body.
#include "core/haptic/haptic_structure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/haptic/voxelmap_sides.hpp"

namespace abstand {
namespace {

// Voxels. Enough for depth-sized margins and for normals near the surface; the far field takes over beyond,
// where its own error is a small part of the distance.
constexpr double kBand = 4.0;
// Spacing of the far field's first grid: so many voxels, or this part of the body's extent, whichever is
// more.
constexpr double kFarSpacing = 2.0;
constexpr double kFarPart = 1.0 / 16.0;
// m; how far the far field's grids reach: a person's reach and more. Beyond, distances to their box do.
constexpr double kFarReach = 2.0;
// Of a voxel: how closely a shape's triangles follow it, where triangles are needed.
constexpr double kSagitta = 0.1;

struct ShapeRadius {
  double operator()(const Sphere& s) const { return s.radius; }
  double operator()(const Ellipsoid& s) const { return s.semi_axes.maxCoeff(); }
  double operator()(const Cuboid& s) const { return 0.5 * s.size.norm(); }
  double operator()(const Cylinder& s) const { return std::hypot(s.radius, 0.5 * s.length); }
  double operator()(const Capsule& s) const { return s.radius + 0.5 * s.length; }
};

EnclosingSphere sphereAbout(const Surface& surface, const TriangleMesh& mesh) {
  if (const Shape* shape = surface.shape()) return {Vector3d::Zero(), std::visit(ShapeRadius{}, *shape)};
  std::vector<Vector3d> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) corners.push_back(mesh.corner(t, i));
  }
  return minimalSphere(corners);
}

std::size_t bytesOf(const Pointshell& shell) { return 7 * sizeof(float) * shell.x.capacity(); }

std::size_t bytesOf(const PointSphereTree& tree) {
  return tree.nodes.capacity() * sizeof(PointSphereTree::Node) + 7 * sizeof(float) * tree.x.capacity() +
         tree.shell_index.capacity() * sizeof(std::uint32_t);
}

}  // namespace

double HapticStructure::errorBound() const {
  // The count of layers is certain to a voxel's diagonal, and its sign on the surface layer to half of one.
  const double layer_error = 1.5 * std::sqrt(3.0) * grid.voxel_size;
  return (near_field ? near_field->errorBound() : layer_error) + shell.covering_radius;
}

std::size_t HapticStructure::memoryBytes() const {
  std::size_t bytes = far_field.memoryBytes() + bytesOf(shell) + bytesOf(tree);
  if (voxelmap) bytes += voxelmap->layer.capacity() * sizeof(std::int16_t);
  if (near_field) bytes += near_field->memoryBytes();
  return bytes;
}

std::shared_ptr<const HapticStructure> buildHapticStructure(std::string name,
                                                            std::shared_ptr<const Surface> surface,
                                                            const HapticOptions& options, int threads) {
  const auto start = std::chrono::steady_clock::now();
  options.validate();
  auto structure = std::make_shared<HapticStructure>();
  HapticStructure& s = *structure;
  s.name = std::move(name);
  s.options = options;
  s.surface = std::move(surface);
  const Bounds box = s.surface->bounds();
  const double h = options.voxel_size;
  s.grid = makeGrid(box, h, options.outer_layers);

  if (options.field == FieldKind::kLayered) {
    s.voxelmap = makeVoxelmap(*s.surface, h, options.outer_layers, threads);
    s.surface_voxels = s.voxelmap->surface_voxels;
    s.solid_voxels = s.voxelmap->solid_voxels;
  } else {
    const VoxelSides sides = findVoxelSides(*s.surface, h, threads);
    s.surface_voxels = sides.surface_voxels;
    s.solid_voxels = sides.solid_voxels;
    s.near_field.emplace(*s.surface, s.grid, options.field == FieldKind::kMixed ? kBand * h : kInfinity,
                         threads);
  }
  s.far_field =
      FarField(*s.surface, std::max(kFarSpacing * h, kFarPart * box.extent().maxCoeff()), kFarReach, threads);
  s.shell = makePointshell(*s.surface, options.point_spacing, threads);
  s.tree = makeTree(s.shell);

  s.mass_properties = s.surface->massProperties();
  s.com = s.mass_properties.com;
  const TriangleMesh mesh = s.surface->mesh(kSagitta * h);
  s.triangles = mesh.triangles.size();
  s.bounding_sphere = sphereAbout(*s.surface, mesh);
  s.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return structure;
}

}  // namespace abstand
