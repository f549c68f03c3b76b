// The surface of a triangle mesh.
#include "core/geometry/mesh_surface.hpp"

#include <cmath>
#include <utility>

#include "core/base/error.hpp"

namespace abstand::geometry {
namespace {

// A triangle without area has no normal. The threshold is relative to the square of the longest edge, so that
// units do not matter; slivers that double can represent are kept.
constexpr double kNoArea = 1e-14;

TriangleMesh checked(TriangleMesh mesh) {
  for (const Vector3d& v : mesh.vertices) {
    if (!v.allFinite()) throw UsageError("the mesh has coordinates that are not finite numbers");
  }
  std::erase_if(mesh.triangles, [&](const std::array<std::uint32_t, 3>& t) {
    for (const std::uint32_t v : t) {
      if (v >= mesh.vertices.size())
        throw UsageError("the mesh has a triangle with a vertex that does not exist");
    }
    const Vector3d ab = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Vector3d ac = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    return !(ab.cross(ac).norm() > kNoArea * longest2);
  });
  if (mesh.triangles.empty()) throw UsageError("the mesh has no triangle with an area");
  return mesh;
}

// Bounds of the vertices that triangles use.
Bounds usedBounds(const TriangleMesh& mesh) {
  Bounds box;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) box.add(mesh.corner(t, i));
  }
  return box;
}

}  // namespace

MeshSurface::MeshSurface(TriangleMesh mesh)
    : mesh_(checked(std::move(mesh))),
      bounds_(usedBounds(mesh_)),
      tree_(mesh_),
      winding_(tree_, mesh_),
      sides_(mesh_, tree_, winding_) {}

SurfacePoint MeshSurface::closest(const Vector3d& p, std::uint32_t hint) const {
  const TriangleTree::Nearest nearest = tree_.closest(p, hint);
  return {nearest.point, nearest.distance, nearest.slot};
}

SurfacePoint MeshSurface::nearby(const Vector3d& p, std::uint32_t hint) const {
  if (hint >= tree_.size() || !watertight()) return closest(p, hint);
  const TriangleTree::Nearest nearest = sides_.downhill(mesh_, tree_, p, hint);
  return {nearest.point, nearest.distance, nearest.slot};
}

bool MeshSurface::inside(const Vector3d& p) const {
  if (((p - bounds_.lower).array() < 0.0).any() || ((bounds_.upper - p).array() < 0.0).any()) return false;
  return embedded() ? sides_.behind(tree_.closest(p), p) : std::abs(winding_.at(p)) > 0.5;
}

bool MeshSurface::inside(const Vector3d& p, const SurfacePoint& closest_to_p) const {
  if (((p - bounds_.lower).array() < 0.0).any() || ((bounds_.upper - p).array() < 0.0).any()) return false;
  return embedded() ? sides_.behind(tree_.closestOn(closest_to_p.hint, p), p)
                    : std::abs(winding_.at(p)) > 0.5;
}

bool MeshSurface::triangle(std::uint32_t hint, TriangleCorners& corners) const {
  if (hint >= tree_.size()) return false;
  const std::size_t t = tree_.triangle(hint);
  corners = {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
  return true;
}

std::unique_ptr<Surface> makeSurface(TriangleMesh mesh) {
  return std::make_unique<MeshSurface>(std::move(mesh));
}

}  // namespace abstand::geometry
