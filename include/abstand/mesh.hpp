// What a body looks like: triangles, or one of five exact shapes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "abstand/pose.hpp"

namespace abstand {

/// Triangles over shared vertices, m, in the body's own frame; counter-clockwise seen from outside. A value.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;                ///< m
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
  /// What a reader noticed: open edges, an inverted mesh, a doubtful unit. A sentence each.
  std::vector<std::string> remarks;
};

/// Reads STL, OBJ, PLY, OFF or DAE by the extension, and what else assimp knows. `scale`: metres per unit of
/// the file, positive. Equal vertices are merged, triangles without area dropped. Any thread. Throws
/// std::runtime_error, one line `FILE:LINE: error: WHAT`, for whatever gives no triangle.
Mesh loadMesh(const std::filesystem::path& file, double scale = 1.0);

/// One of five exact shapes, centred on its own frame. A value, made by the five functions, which throw
/// std::runtime_error for sizes (m) that are not finite or not between 1e-6 and 1e6. Any thread.
class Shape {
 public:
  /// Which of them.
  enum class Kind { kSphere, kEllipsoid, kCuboid, kCylinder, kCapsule };

  /// All points within `radius` (m).
  static Shape sphere(double radius);
  /// By its three half axes (m).
  static Shape ellipsoid(const Eigen::Vector3d& semi_axes);
  /// By the full lengths of its edges (m).
  static Shape cuboid(const Eigen::Vector3d& size);
  /// About z; `length` (m) from cap to cap.
  static Shape cylinder(double radius, double length);
  /// About z; `length` (m) of the cylindrical part, so length + 2 radius in all; it may be 0.
  static Shape capsule(double radius, double length);

  /// Which shape it is.
  Kind kind() const { return kind_; }
  /// Sphere: (radius, 0, 0). Ellipsoid: semi-axes. Cuboid: edges. Cylinder, capsule: (radius, length, 0). m.
  const Eigen::Vector3d& sizes() const { return sizes_; }

 private:
  Shape(Kind kind, const Eigen::Vector3d& sizes);
  Kind kind_;
  Eigen::Vector3d sizes_;
};

}  // namespace abstand
