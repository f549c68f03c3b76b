// What the haptic structures need to know of a body: its exact surface, whatever it is made of.
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
  std::uint32_t hint{kNoHint};  ///< where it was found; speeds up a query nearby
};

/// The exact surface of one body, in the body's frame (m). Constant after construction: every function
/// is safe from any number of threads, allocates nothing and does not throw.
class Surface {
 public:
  virtual ~Surface() = default;

  /// Nearest point of the surface. `hint` is the hint of an earlier answer, or kNoHint.
  virtual SurfacePoint closest(const Vector3d& p, std::uint32_t hint = kNoHint) const = 0;
  /// Downhill along the surface from where an answer nearby was found: the nearest point of the
  /// neighbourhood, and the nearest of all where the surface is convex. Without a hint, closest(p).
  virtual SurfacePoint nearby(const Vector3d& p, std::uint32_t) const { return closest(p); }
  /// True inside. Shapes: exact. Meshes that are closed and do not intersect themselves: the side of the
  /// angle-weighted normal at the nearest point (Baerentzen, Aanaes 2005). Others: generalised winding number
  /// (Jacobson, Kavan, Sorkine-Hornung 2013) beyond one half, of either sign, as pieces of such meshes may be
  /// inside out. Outside of the bounds always false.
  virtual bool inside(const Vector3d& p) const = 0;
  /// inside(p), given closest(p), which makes it cheaper.
  virtual bool inside(const Vector3d& p, const SurfacePoint& closest_to_p) const = 0;
  /// The triangle on which the point with this hint lies. False where the surface has none, and for kNoHint.
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
  /// The shape, when this is one; else null.
  virtual const Shape* shape() const { return nullptr; }
};

/// Throws UsageError for a shape that is not valid.
std::unique_ptr<Surface> makeSurface(const Shape& shape);
/// Takes a welded mesh. Throws UsageError for a mesh without a triangle of positive area or with
/// coordinates that are not finite.
std::unique_ptr<Surface> makeSurface(TriangleMesh mesh);

}  // namespace abstand::geometry
