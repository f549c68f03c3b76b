// The triangles of a body, ready for questions about contact patches.
#pragma once

#include <span>

#include "core/geometry/surface.hpp"
#include "core/geometry/triangle_tree.hpp"

namespace abstand::contact {

/// m: how far the triangles of a curved shape may be from it.
inline constexpr double kContactSagitta = 5e-5;
/// The same as a share of the body's largest extent, so that a large body does not become too many triangles.
inline constexpr double kContactSagittaShare = 1e-4;

/// The exact triangles of a mesh, or an inscribed tessellation of a shape. Body frame, m. Constant after
/// construction; every function is safe from any thread.
class ContactSurface {
 public:
  /// Shapes: triangles within `sagitta` (m), or within kContactSagittaShare of the extent where that is more.
  /// Throws UsageError for a sagitta that is not positive, or too small for the shape.
  explicit ContactSurface(const geometry::Surface& surface, double sagitta = kContactSagitta);

  const geometry::TriangleMesh& mesh() const { return mesh_; }
  /// m; 0 for meshes and cuboids, whose triangles are exact. A curved shape contains its triangles.
  double sagitta() const { return sagitta_; }
  /// Closed, and its triangles point outwards.
  bool watertight() const { return watertight_; }
  /// The point of the surface nearest to p, and the index of its triangle.
  struct Nearest {
    Vector3d point;
    std::uint32_t triangle;
  };
  Nearest nearest(const Vector3d& p) const {
    const geometry::TriangleTree::Nearest found = tree_.closest(p);
    return {found.point, tree_.triangle(found.slot)};
  }
  /// The triangles that share a vertex.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const {
    return {around_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }

 private:
  geometry::TriangleMesh mesh_;
  double sagitta_{0.0};
  bool watertight_{false};
  geometry::TriangleTree tree_;
  std::vector<std::uint32_t> first_, around_;
};

}  // namespace abstand::contact
