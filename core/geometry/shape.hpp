// The five shapes of a scene file, each centred on its own frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/geometry/mass_properties.hpp"

namespace abstand::geometry {

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

/// The dimensions (m) in the order of the members, at most three; the rest is 0.
Vector3d dimensionsOf(const Shape& shape);
/// The way back; `kind` is the shape's place in the variant, from 0. nullopt for a kind that is none. The
/// shape may still be invalid.
std::optional<Shape> shapeOf(std::size_t kind, const Vector3d& dimensions);

/// Limits of a shape's dimensions, m. They keep squares, areas and inertias far from overflow.
inline constexpr double kMinDimension = 1e-6;
inline constexpr double kMaxDimension = 1e6;

/// Throws UsageError when a dimension is not finite or not between the limits (a capsule's length may
/// be 0 too). The functions below take valid shapes only.
void validate(const Shape& shape);

/// `sphere:r`, `cuboid:x,y,z`, `ellipsoid:a,b,c`, `cylinder:r,l`, `capsule:r,l` in metres.
/// nullopt when the word before the colon is no shape; throws UsageError for a shape with wrong numbers.
std::optional<Shape> parseShape(std::string_view text);

/// Nearest point of the surface, and the signed distance to it: positive outside, negative inside.
/// Exact to 1e-12 relative; the ellipsoid by a safeguarded Newton iteration (Eberly, Distance from a
/// Point to an Ellipsoid). Where several points are nearest, one of them. p is finite and nearer than
/// 1e100 m. No allocation; pure.
struct ShapeDistance {
  Vector3d nearest;
  double distance;
};
ShapeDistance distanceTo(const Shape& shape, const Vector3d& p);

Bounds bounds(const Shape& shape);
double surfaceArea(const Shape& shape);  ///< m^2, to rounding (ellipsoid: Carlson's symmetric integrals)
MassProperties massProperties(const Shape& shape);

/// Most triangles that tessellate() makes.
inline constexpr std::size_t kMaxTessellation = 4'000'000;

/// Closed mesh with vertices on the surface and outward triangles. No point of the shape's surface is
/// farther than `sagitta` (m) from the mesh. At least 32 triangles round a curved circumference; a ball
/// is covered evenly, without poles, and an ellipsoid is a stretched ball.
/// Throws UsageError when `sagitta` is not positive, or so small that it takes kMaxTessellation.
TriangleMesh tessellate(const Shape& shape, double sagitta);

}  // namespace abstand::geometry
