// Geometry of a body: a triangle mesh, or one of five exact shapes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "abstand/pose.hpp"

namespace abstand {

/// Triangles with shared vertices, m, in the frame of the body; counter-clockwise seen from outside. A value.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;                ///< m
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
  /// Remarks of the reader, one sentence each: open edges, an inverted mesh, a doubtful unit.
  std::vector<std::string> remarks;
};

/// Reads STL, OBJ, PLY, OFF or DAE by the extension, and other formats by assimp. `scale`: metres per unit of
/// the file, positive. Equal vertices are merged, triangles without area are dropped. Any thread. Throws
/// std::runtime_error, one line `FILE:LINE: error: WHAT`, if there is no triangle.
Mesh loadMesh(const std::filesystem::path& file, double scale = 1.0);

/// One of five exact shapes, centred on its frame. A value, created by the five functions, which throw
/// std::runtime_error for sizes (m) that are not finite or not between 1e-6 and 1e6. Any thread.
class Shape {
 public:
  /// Type of a shape.
  enum class Kind { kSphere, kEllipsoid, kCuboid, kCylinder, kCapsule };

  /// Sphere of `radius` (m).
  static Shape sphere(double radius);
  /// Ellipsoid with three semi-axes (m).
  static Shape ellipsoid(const Eigen::Vector3d& semi_axes);
  /// Cuboid with the full lengths of its edges (m).
  static Shape cuboid(const Eigen::Vector3d& size);
  /// Cylinder about z; `length` (m) from cap to cap.
  static Shape cylinder(double radius, double length);
  /// Capsule about z; `length` (m) of the cylindrical part, may be 0; the total length is length + 2 radius.
  static Shape capsule(double radius, double length);

  /// Type of this shape.
  Kind kind() const { return kind_; }
  /// Sphere: (radius, 0, 0). Ellipsoid: semi-axes. Cuboid: edges. Cylinder, capsule: (radius, length, 0). m.
  const Eigen::Vector3d& sizes() const { return sizes_; }

 private:
  Shape(Kind kind, const Eigen::Vector3d& sizes);
  Kind kind_;
  Eigen::Vector3d sizes_;
};

}  // namespace abstand
