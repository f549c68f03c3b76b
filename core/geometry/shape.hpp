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

/// Dimensions (m) in the order of the members, at most three; unused entries are 0.
Vector3d dimensionsOf(const Shape& shape);
/// Inverse of dimensionsOf(). `kind` is the index in the variant; nullopt if out of range. The shape may
/// still be invalid.
std::optional<Shape> shapeOf(std::size_t kind, const Vector3d& dimensions);

/// Limits of a shape's dimensions, m. They prevent overflow of squares, areas and inertias.
inline constexpr double kMinDimension = 1e-6;
inline constexpr double kMaxDimension = 1e6;

/// Throws UsageError when a dimension is not finite or not between the limits (a capsule's length may
/// be 0 too). The functions below take valid shapes only.
void validate(const Shape& shape);

/// `sphere:r`, `cuboid:x,y,z`, `ellipsoid:a,b,c`, `cylinder:r,l`, `capsule:r,l` in metres.
/// nullopt if the word before the colon is not a shape; throws UsageError for a shape with wrong numbers.
std::optional<Shape> parseShape(std::string_view text);

/// Nearest point of the surface and the signed distance to it: positive outside, negative inside. Relative
/// accuracy 1e-12; for ellipsoids by a safeguarded Newton iteration (Eberly, Distance from a Point to an
/// Ellipsoid). If several points are nearest, one of them. p is finite and nearer than 1e100 m. No
/// allocation; pure.
struct ShapeDistance {
  Vector3d nearest;
  double distance;
};
ShapeDistance distanceTo(const Shape& shape, const Vector3d& p);

Bounds bounds(const Shape& shape);
double surfaceArea(const Shape& shape);  ///< m^2, to rounding (ellipsoid: Carlson's symmetric integrals)
MassProperties massProperties(const Shape& shape);

/// Largest number of triangles that tessellate() makes.
inline constexpr std::size_t kMaxTessellation = 4'000'000;

/// Closed mesh with vertices on the surface and outward triangles; no point of the surface is farther than
/// `sagitta` (m) from the mesh. At least 32 segments around a curved circumference. A sphere is subdivided
/// evenly, without poles; an ellipsoid is a scaled sphere. Throws UsageError if `sagitta` is not positive, or
/// so small that it would take more than kMaxTessellation triangles.
TriangleMesh tessellate(const Shape& shape, double sagitta);

}  // namespace abstand::geometry
