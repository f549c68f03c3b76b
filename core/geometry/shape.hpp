// The five shapes of a scene file, each centred on its own frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/geometry/mass_properties.hpp"

namespace abstand {

struct Sphere {
  double radius;
};
struct Ellipsoid {
  Vector3d semi_axes;
};
struct Cuboid {
  Vector3d size;  ///< full edge lengths
};
/// Axis along z, `length` from cap to cap.
struct Cylinder {
  double radius, length;
};
/// Axis along z, `length` of the cylindrical middle part, so length + 2 radius in all.
struct Capsule {
  double radius, length;
};
using Shape = std::variant<Sphere, Ellipsoid, Cuboid, Cylinder, Capsule>;

/// "sphere", "ellipsoid", "cuboid", "cylinder" or "capsule".
std::string_view shapeName(const Shape& shape);

/// Throws UsageError when a dimension is not finite and positive (a capsule's length may be 0).
void validate(const Shape& shape);

/// `sphere:r`, `cuboid:x,y,z`, `ellipsoid:a,b,c`, `cylinder:r,l`, `capsule:r,l` in metres.
/// nullopt when the word before the colon is no shape; throws UsageError for a shape with wrong numbers.
std::optional<Shape> parseShape(std::string_view text);

/// Nearest point of the surface, and the signed distance to it: positive outside, negative inside.
/// Exact to 1e-12 relative; the ellipsoid by a safeguarded Newton iteration (Eberly, Distance from a
/// Point to an Ellipsoid). Where several points are nearest, one of them. No allocation.
struct ShapeDistance {
  Vector3d nearest;
  double distance;
};
ShapeDistance distanceTo(const Shape& shape, const Vector3d& p);

Bounds bounds(const Shape& shape);
double surfaceArea(const Shape& shape);  ///< m^2; ellipsoid by Carlson's symmetric integrals or to 1e-9 relative
MassProperties massProperties(const Shape& shape);

/// Closed mesh with vertices on the surface and outward triangles. No point of the shape's surface is
/// farther than `sagitta` (m) from the mesh. At least 32 triangles round a curved circumference.
TriangleMesh tessellate(const Shape& shape, double sagitta);

}  // namespace abstand
