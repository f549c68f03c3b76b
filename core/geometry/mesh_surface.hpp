// The surface of a triangle mesh.
#pragma once

#include "core/geometry/mesh_surface_sides.hpp"
#include "core/geometry/surface.hpp"
#include "core/geometry/winding_number.hpp"

namespace abstand::geometry {

/// Exact surface of a mesh: nearest points by a box tree, inside test as in Surface::inside. The hint of a
/// result is a slot of the tree.
class MeshSurface final : public Surface {
 public:
  /// Takes a welded mesh; triangles without area are dropped. Throws UsageError for coordinates that are not
  /// finite, an index beyond the vertices, or no triangle left.
  explicit MeshSurface(TriangleMesh mesh);
  /// Empty; only archive() may fill it.
  MeshSurface() = default;
  template <class Archive>
  void archive(Archive& ar) {
    ar(mesh_.vertices, mesh_.triangles, bounds_.lower, bounds_.upper, tree_, winding_, sides_);
  }

  SurfacePoint closest(const Vector3d& p, std::uint32_t hint = kNoHint) const override;
  SurfacePoint nearby(const Vector3d& p, std::uint32_t hint) const override;
  bool inside(const Vector3d& p) const override;
  bool inside(const Vector3d& p, const SurfacePoint& closest_to_p) const override;
  bool triangle(std::uint32_t hint, TriangleCorners& corners) const override;
  Bounds bounds() const override { return bounds_; }
  MassProperties massProperties() const override { return abstand::geometry::massProperties(mesh_); }
  double area() const override { return surfaceArea(mesh_); }
  TriangleMesh mesh(double) const override { return mesh_; }
  bool watertight() const override { return sides_.watertight(); }

  /// True if the mesh is the boundary of a solid: closed, without intersecting triangles, and no component
  /// wrongly nested in another. Then normals decide about inside and outside; otherwise winding numbers.
  bool embedded() const { return sides_.embedded(); }
  const TriangleTree& tree() const { return tree_; }
  const WindingNumber& windingNumber() const { return winding_; }

 private:
  TriangleMesh mesh_;
  Bounds bounds_;
  TriangleTree tree_;
  WindingNumber winding_;
  MeshSides sides_;
};

}  // namespace abstand::geometry
