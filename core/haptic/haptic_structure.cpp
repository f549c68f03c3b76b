#include "core/haptic/haptic_structure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace abstand {
namespace {

constexpr double kMixedBand = 4.0;      // voxels: where forces of ordinary penetrations live
constexpr double kFarSpacing = 2.0;     // voxels of the first far grid, or
constexpr double kFarCells = 16.0;      // this part of the body's extent, whichever is coarser
constexpr double kFarReach = 2.0;       // m: a person's reach and more
constexpr double kCountSagitta = 0.02;  // voxels, of the tessellation that stands for a shape's triangles

template <class T>
std::size_t bytesOf(const std::vector<T>& v) {
  return v.size() * sizeof(T);
}

}  // namespace

double HapticStructure::errorBound() const {
  // A layer is certain to a voxel's diagonal and a half [design: sqrt(3)/2 for the sign, one layer for the
  // count].
  const double field = near_field ? near_field->errorBound() : 1.5 * std::sqrt(3.0) * options.voxel_size;
  return field + shell.covering_radius;
}

std::size_t HapticStructure::memoryBytes() const {
  std::size_t bytes = far_field.memoryBytes();
  if (near_field) bytes += near_field->memoryBytes();
  if (voxelmap) bytes += bytesOf(voxelmap->layer);
  for (const auto* v : {&shell.x, &shell.y, &shell.z, &shell.nx, &shell.ny, &shell.nz, &shell.area, &tree.x,
                        &tree.y, &tree.z, &tree.nx, &tree.ny, &tree.nz, &tree.area})
    bytes += bytesOf(*v);
  return bytes + bytesOf(tree.nodes) + bytesOf(tree.shell_index);
}

std::shared_ptr<const HapticStructure> buildHapticStructure(std::string name,
                                                            std::shared_ptr<const Surface> surface,
                                                            const HapticOptions& options, int threads) {
  options.validate();
  const auto begin = std::chrono::steady_clock::now();
  auto s = std::make_shared<HapticStructure>();
  s->name = std::move(name);
  s->options = options;
  s->surface = std::move(surface);
  const Surface& body = *s->surface;
  const double voxel = options.voxel_size;
  s->grid = makeGrid(body.bounds(), voxel, options.outer_layers);

  // The voxelmap is kept for layered fields; the others only report its counts, for which no outer layer is
  // needed.
  const bool layered = options.field == FieldKind::kLayered;
  Voxelmap map = makeVoxelmap(body, voxel, layered ? options.outer_layers : 0, threads);
  s->surface_voxels = map.surface_voxels;
  s->solid_voxels = map.solid_voxels;
  if (layered)
    s->voxelmap = std::move(map);
  else
    s->near_field.emplace(body, s->grid, options.field == FieldKind::kFloat ? kInfinity : kMixedBand * voxel,
                          threads);
  s->far_field = FarField(body, std::max(kFarSpacing * voxel, body.bounds().extent().maxCoeff() / kFarCells),
                          kFarReach, threads);

  s->shell = makePointshell(body, options.point_spacing);
  s->tree = makeTree(s->shell);
  std::vector<Vector3d> points(s->shell.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = s->shell.point(i);
  s->bounding_sphere = minimalSphere(points);
  s->bounding_sphere.radius += s->shell.covering_radius;
  s->mass_properties = body.massProperties();
  s->com = s->mass_properties.com;
  s->triangles = body.mesh(kCountSagitta * voxel).triangles.size();
  s->build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return s;
}

}  // namespace abstand
