// Exact distances over all pairs of triangles. Shares no code with the engine under test.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::verify {

using Triangle = std::array<Vector3d, 3>;

/// Euclidean distances (m) in double. Degenerate triangles and segments are allowed. Each is the distance of
/// two points that lie on the two objects, so rounding can only make it too large.
double distancePointSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b);
double distanceSegments(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d);
double distancePointTriangle(const Vector3d& p, const Triangle& t);
/// 0 if they intersect.
double distanceTriangles(const Triangle& s, const Triangle& t);

/// A mesh as a list of triangles, each with a bounding sphere for pruning.
class TriangleSoup {
 public:
  explicit TriangleSoup(const geometry::TriangleMesh& mesh);

  std::size_t size() const { return triangles_.size(); }
  const Triangle& operator[](std::size_t i) const { return triangles_[i]; }
  TriangleSoup moved(const Transform& X) const;

  /// Unsigned distance from p to the nearest triangle.
  double distanceTo(const Vector3d& p) const;
  /// Smallest distance to a triangle of `other` (same frame); 0 if the surfaces intersect.
  double distanceTo(const TriangleSoup& other) const;
  /// Winding number: sum of the solid angles of the triangles at p, over 4 pi (van Oosterom, Strackee 1983):
  /// 1 inside a closed mesh, 0 outside.
  double windingNumber(const Vector3d& p) const;
  bool inside(const Vector3d& p) const { return std::abs(windingNumber(p)) > 0.5; }
  /// One corner of each connected component (triangles that share a corner).
  const std::vector<Vector3d>& probes() const { return probes_; }

 private:
  struct Ball {
    Vector3d centre;
    double radius;
  };
  TriangleSoup() = default;
  void add(const Triangle& t);

  std::vector<Triangle> triangles_;
  std::vector<Ball> balls_;
  std::vector<Vector3d> probes_;
};

}  // namespace abstand::verify
