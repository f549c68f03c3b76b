// What the penalty force of a half-space pressed into a body should be.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/geometry/surface.hpp"
#include "core/geometry/triangle_mesh.hpp"
#include "core/shell/pointshell_tree.hpp"

namespace abstand::shell {

/// The half-space is u . x < level; the depth of a point in it is d(x) = level - u . x. The force for
/// stiffness 1 is -(integral of max(0, d) n dA) over the surface with its outward normals n, which for a
/// closed body is the overlapping volume times u. Shared by threads.
class HalfSpaceOverlap {
 public:
  virtual ~HalfSpaceOverlap() = default;
  /// m: least u . x over the body, to float's rounding.
  virtual double lowest(const Vector3d& u) const = 0;
  /// Forces (m^3) for rising levels; 0 for an overlap that is none: the two sides of a sheet.
  virtual void forces(const Vector3d& u, std::span<const double> levels, std::span<Vector3d> out) const = 0;
};

/// The cap of an ellipsoid, in closed form: a ball's, stretched.
class EllipsoidOverlap final : public HalfSpaceOverlap {
 public:
  explicit EllipsoidOverlap(const Vector3d& semi_axes) : semi_axes_(semi_axes) {}
  double lowest(const Vector3d& u) const override { return -semi_axes_.cwiseProduct(u).norm(); }
  void forces(const Vector3d& u, std::span<const double> levels, std::span<Vector3d> out) const override;

 private:
  Vector3d semi_axes_;
};

/// Triangle by triangle; the mesh may be open.
class MeshOverlap final : public HalfSpaceOverlap {
 public:
  explicit MeshOverlap(geometry::TriangleMesh mesh);
  double lowest(const Vector3d& u) const override;
  void forces(const Vector3d& u, std::span<const double> levels, std::span<Vector3d> out) const override;

 private:
  geometry::TriangleMesh mesh_;
  PointsBelow vertices_below_;
  /// The triangles at each vertex: those of v are list_[first_[v]] ... list_[first_[v + 1] - 1].
  std::vector<std::uint32_t> first_, list_;
};

/// In closed form for a ball and an ellipsoid, else over triangles within `sagitta` (m) of the surface.
std::unique_ptr<HalfSpaceOverlap> halfSpaceOverlap(const geometry::Surface& surface, double sagitta);

}  // namespace abstand::shell
