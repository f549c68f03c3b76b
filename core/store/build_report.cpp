// Quality report of a haptic structure.
#include "core/store/build_report.hpp"

#include "core/base/parallel.hpp"
#include "core/geometry/convex_hull.hpp"
#include "core/geometry/mesh_surface.hpp"
#include "core/mesh_file/mesh_report.hpp"

namespace abstand::store {
namespace {

constexpr double kThinVoxels = 2.0;
constexpr double kReportSagitta = 0.1;      // share of a voxel, for the triangles of a shape
constexpr std::size_t kPointsABlock = 256;  // for each call of the parallel loops

/// Distance from p along the unit vector n to the first triangle crossed from inside to outside, or infinity
/// beyond `reach`. Triangles crossed inwards are ignored: the wall begins at p.
double exitDistance(const geometry::TriangleMesh& mesh, const geometry::TriangleTree& tree, const Vector3d& p,
                    const Vector3d& n, double reach) {
  geometry::Bounds box;
  box.add(p);
  box.add(p + reach * n);
  double smallest = kInfinity;
  tree.forOverlapping(box, [&](std::uint32_t slot) {
    const double across = tree.normal(slot).dot(n);
    // Nearly parallel to the ray: a side face of the wall.
    constexpr double kAlong = 1e-6;
    if (across <= kAlong) return;
    const std::uint32_t t = tree.triangle(slot);
    const Vector3d a = mesh.corner(t, 0) - p, b = mesh.corner(t, 1) - p, c = mesh.corner(t, 2) - p;
    const double distance = a.dot(tree.normal(slot)) / across;
    if (distance < 0.0 || distance >= smallest || distance >= reach) return;
    // The ray crosses the triangle if it passes all edges on the same side (signed volumes).
    if (n.dot(a.cross(b)) >= 0.0 && n.dot(b.cross(c)) >= 0.0 && n.dot(c.cross(a)) >= 0.0) smallest = distance;
  });
  return smallest;
}

/// Smallest `value` over the shell points and its point; the first of equal ones.
struct Extreme {
  double value;
  std::size_t point;
};
Extreme smallestOf(const std::vector<double>& values) {
  Extreme e{kInfinity, 0};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] < e.value) e = {values[i], i};
  }
  return e;
}

/// Calls fn(point) for every shell point, in parallel.
template <class Fn>
std::vector<double> ofPoints(const shell::Pointshell& shell, Fn&& fn) {
  std::vector<double> values(shell.size());
  parallelFor(0, (shell.size() + kPointsABlock - 1) / kPointsABlock, [&](std::size_t block) {
    const std::size_t end = std::min((block + 1) * kPointsABlock, shell.size());
    for (std::size_t i = block * kPointsABlock; i < end; ++i) values[i] = fn(i);
  });
  return values;
}

BuildReport::ThinWalls thinWalls(const structure::HapticStructure& s, const geometry::TriangleMesh& mesh) {
  BuildReport::ThinWalls walls;
  walls.below = kThinVoxels * s.options.voxel_size;
  const geometry::TriangleTree tree(mesh);
  const std::vector<double> ways = ofPoints(s.shell, [&](std::size_t i) {
    return exitDistance(mesh, tree, s.shell.point(i), s.shell.normal(i).normalized(), walls.below);
  });
  double thin = 0.0, all = 0.0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    all += s.shell.area[i];
    if (ways[i] < walls.below) thin += s.shell.area[i];
  }
  walls.share = all > 0.0 ? thin / all : 0.0;
  const Extreme thinnest = smallestOf(ways);
  if (thinnest.value < walls.below) {
    walls.thinnest = thinnest.value;
    walls.where = s.shell.point(thinnest.point);
  }
  return walls;
}

std::optional<BuildReport::Hull> hullOf(const structure::HapticStructure& s,
                                        const geometry::TriangleMesh& mesh) {
  const auto hull = geometry::convexHull(mesh.vertices);
  if (!hull) return std::nullopt;
  BuildReport::Hull result;
  if (s.mass_properties.volume > 0.0) result.volume_ratio = hull->volume / s.mass_properties.volume;
  const Extreme deepest =
      smallestOf(ofPoints(s.shell, [&](std::size_t i) { return -hull->depth(s.shell.point(i)); }));
  result.worst = std::max(0.0, -deepest.value);
  result.where = s.shell.point(deepest.point);
  return result;
}

}  // namespace

BuildReport reportOn(const structure::HapticStructure& s) {
  BuildReport report;
  const geometry::TriangleMesh mesh = s.surface->mesh(kReportSagitta * s.options.voxel_size);
  report.thin_walls = thinWalls(s, mesh);
  if (s.surface->shape() != nullptr) {
    // Every shape is convex.
    report.hull = BuildReport::Hull{1.0, 0.0, Vector3d::Constant(kNaN)};
    return report;
  }
  const mesh_file::MeshReport edges = mesh_file::inspect(mesh);
  report.open_edges = edges.open_edges;
  report.non_manifold_edges = edges.non_manifold_edges;
  report.flipped_edges = edges.flipped_edges;
  const auto* surface = dynamic_cast<const geometry::MeshSurface*>(s.surface.get());
  report.inside_doubtful = surface != nullptr ? !surface->embedded() : !s.surface->watertight();
  report.hull = hullOf(s, mesh);
  return report;
}

}  // namespace abstand::store
