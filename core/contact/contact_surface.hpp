// Triangles of a body, prepared for contact patches.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

#include "core/geometry/surface.hpp"
#include "core/geometry/triangle_tree.hpp"

namespace abstand::contact {

/// m: sagitta of the triangles of a curved shape.
inline constexpr double kContactSagitta = 5e-5;
/// The same as a share of the body's largest extent, to limit the triangles of a large body.
inline constexpr double kContactSagittaShare = 1e-4;

/// The exact triangles of a mesh, or an inscribed tessellation of a shape. Body frame, m. Constant after
/// construction; every function is thread-safe.
class ContactSurface {
 public:
  /// Shapes: triangles within `sagitta` (m), or kContactSagittaShare of the extent if that is more. Throws
  /// UsageError for a sagitta that is not positive, or too small for the shape.
  explicit ContactSurface(const geometry::Surface& surface, double sagitta = kContactSagitta);

  const geometry::TriangleMesh& mesh() const { return mesh_; }
  /// m; 0 for meshes and cuboids, whose triangles are exact. A curved shape contains its triangles.
  double sagitta() const { return sagitta_; }
  /// True if it is closed and its triangles face outwards.
  bool watertight() const { return watertight_; }
  /// Nearest surface point to p, and the index of its triangle.
  struct Nearest {
    Vector3d point;
    std::uint32_t triangle;
  };
  Nearest nearest(const Vector3d& p) const {
    const geometry::TriangleTree::Nearest found = tree_.closest(p);
    return {found.point, tree_.triangle(found.slot)};
  }
  /// Some neighbouring triangles and a box around them: |p - centre| <= half for each of their points.
  struct Cluster {
    Vector3d centre, half;
    std::span<const std::uint32_t> triangles;
  };
  /// All triangles, each in one cluster.
  std::size_t clusters() const { return boxes_.size(); }
  Cluster cluster(std::size_t i) const {
    const std::size_t first = i * kClusterTriangles;
    return {boxes_[i].first, boxes_[i].second,
            std::span(clustered_).subspan(first, std::min(kClusterTriangles, clustered_.size() - first))};
  }
  /// Triangles that share a vertex.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const {
    return {around_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }

 private:
  static constexpr std::size_t kClusterTriangles = 16;

  void makeClusters();

  geometry::TriangleMesh mesh_;
  double sagitta_{0.0};
  bool watertight_{false};
  geometry::TriangleTree tree_;
  std::vector<std::uint32_t> first_, around_;
  std::vector<std::uint32_t> clustered_;              ///< triangles in the order of the clusters
  std::vector<std::pair<Vector3d, Vector3d>> boxes_;  ///< of clusters: centre, half extent
};

}  // namespace abstand::contact
