// Exact distances by looking at every pair of triangles. Shares no code with the engine that it judges.
#pragma once

#include <array>
#include <vector>

#include "core/geometry/triangle_mesh.hpp"

namespace abstand::verify {

using Triangle = std::array<Vector3d, 3>;

/// Euclidean distances (m) in double. Degenerate triangles and segments are allowed. Each is the distance of
/// two points that really lie on the two things, so rounding can only make it too large.
double distancePointSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b);
double distanceSegments(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d);
double distancePointTriangle(const Vector3d& p, const Triangle& t);
/// 0 when they cut each other.
double distanceTriangles(const Triangle& s, const Triangle& t);

/// A mesh as a bag of triangles, each with a sphere about it to skip the hopeless ones.
class TriangleSoup {
 public:
  explicit TriangleSoup(const geometry::TriangleMesh& mesh);

  std::size_t size() const { return triangles_.size(); }
  const Triangle& operator[](std::size_t i) const { return triangles_[i]; }
  TriangleSoup moved(const Transform& X) const;

  /// Unsigned distance from p to the nearest triangle.
  double distanceTo(const Vector3d& p) const;
  /// Smallest distance to a triangle of `other` (same frame); 0 when the surfaces cut each other.
  double distanceTo(const TriangleSoup& other) const;
  /// Sum of the solid angles that the triangles span at p, over 4 pi (van Oosterom, Strackee 1983): 1 inside
  /// a closed mesh, 0 outside, whatever its shape.
  double windingNumber(const Vector3d& p) const;
  bool inside(const Vector3d& p) const { return std::abs(windingNumber(p)) > 0.5; }
  /// One corner of each connected piece (triangles that share a corner).
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
