// Exact penalty force of a body pressed into a half-space: reference for the quadrature correction.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/geometry/surface.hpp"
#include "core/geometry/triangle_mesh.hpp"
#include "core/shell/pointshell_tree.hpp"

namespace abstand::shell {

/// Half-space u . x < level; the depth of a point in it is level - u . x. The force for stiffness 1 is
/// -(integral of max(0, depth) n dA) over the surface with outward normals n; for a closed body it is the
/// overlapping volume times u. Thread-safe.
class HalfSpaceOverlap {
 public:
  virtual ~HalfSpaceOverlap() = default;
  /// Smallest u . x over the body (m), up to rounding in float.
  virtual double lowest(const Vector3d& u) const = 0;
  /// Forces (m^3) for ascending levels; 0 where the two sides of a sheet cancel.
  virtual void forces(const Vector3d& u, std::span<const double> levels, std::span<Vector3d> out) const = 0;
};

/// Ellipsoid: closed form, a spherical cap scaled by the semi-axes.
class EllipsoidOverlap final : public HalfSpaceOverlap {
 public:
  explicit EllipsoidOverlap(const Vector3d& semi_axes) : semi_axes_(semi_axes) {}
  double lowest(const Vector3d& u) const override { return -semi_axes_.cwiseProduct(u).norm(); }
  void forces(const Vector3d& u, std::span<const double> levels, std::span<Vector3d> out) const override;

 private:
  Vector3d semi_axes_;
};

/// Mesh: sum over its triangles; the mesh may be open.
class MeshOverlap final : public HalfSpaceOverlap {
 public:
  explicit MeshOverlap(geometry::TriangleMesh mesh);
  double lowest(const Vector3d& u) const override;
  void forces(const Vector3d& u, std::span<const double> levels, std::span<Vector3d> out) const override;

 private:
  geometry::TriangleMesh mesh_;
  PointsBelow vertices_below_;
  /// Triangles at each vertex: those of v are list_[first_[v]] ... list_[first_[v + 1] - 1].
  std::vector<std::uint32_t> first_, list_;
};

/// Closed form for a sphere and an ellipsoid, otherwise over triangles within `sagitta` (m) of the surface.
std::unique_ptr<HalfSpaceOverlap> halfSpaceOverlap(const geometry::Surface& surface, double sagitta);

}  // namespace abstand::shell
