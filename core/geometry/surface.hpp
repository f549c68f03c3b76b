// Interface to the exact surface of a body, of whatever representation.
#pragma once

#include <cstdint>
#include <memory>

#include "core/geometry/shape.hpp"
#include "core/geometry/triangle_pair.hpp"

namespace abstand::geometry {

inline constexpr std::uint32_t kNoHint = 0xffffffffu;

struct SurfacePoint {
  Vector3d point;               ///< nearest point of the surface
  double distance;              ///< unsigned, m
  std::uint32_t hint{kNoHint};  ///< location on the surface; speeds up a query nearby
};

/// The exact surface of one body, in the body's frame (m). Constant after construction: every function
/// is safe from any number of threads, allocates nothing and does not throw.
class Surface {
 public:
  virtual ~Surface() = default;

  /// Nearest point of the surface. `hint` is that of an earlier result, or kNoHint.
  virtual SurfacePoint closest(const Vector3d& p, std::uint32_t hint = kNoHint) const = 0;
  /// Local descent along the surface from the hint of a nearby result: the nearest point of the
  /// neighbourhood, and the global one if the surface is convex. Without a hint, closest(p).
  virtual SurfacePoint nearby(const Vector3d& p, std::uint32_t) const { return closest(p); }
  /// True inside. Shapes: exact. Closed meshes without self-intersection: side of the angle-weighted normal
  /// at the nearest point (Baerentzen, Aanaes 2005). Other meshes: |generalised winding number| (Jacobson,
  /// Kavan, Sorkine-Hornung 2013) above one half; the absolute value, as components of such meshes may be
  /// inverted. Outside of the bounds always false.
  virtual bool inside(const Vector3d& p) const = 0;
  /// inside(p), faster with a given closest(p).
  virtual bool inside(const Vector3d& p, const SurfacePoint& closest_to_p) const = 0;
  /// The triangle with this hint. False if the surface has no triangles, and for kNoHint.
  virtual bool triangle(std::uint32_t hint, TriangleCorners& corners) const = 0;
  /// Positive outside, negative inside.
  double signedDistance(const Vector3d& p, std::uint32_t hint = kNoHint) const {
    const SurfacePoint nearest = closest(p, hint);
    return inside(p, nearest) ? -nearest.distance : nearest.distance;
  }

  virtual Bounds bounds() const = 0;
  virtual MassProperties massProperties() const = 0;
  virtual double area() const = 0;
  /// For drawing and sampling: the mesh itself, or a tessellation within `sagitta` (m) of the shape.
  virtual TriangleMesh mesh(double sagitta) const = 0;
  /// Closed and consistently oriented, so that inside and outside are certain.
  virtual bool watertight() const = 0;
  /// The shape if the body is one; otherwise null.
  virtual const Shape* shape() const { return nullptr; }
};

/// Throws UsageError for an invalid shape.
std::unique_ptr<Surface> makeSurface(const Shape& shape);
/// Takes a welded mesh. Throws UsageError for a mesh without a triangle of positive area or with
/// coordinates that are not finite.
std::unique_ptr<Surface> makeSurface(TriangleMesh mesh);

}  // namespace abstand::geometry
