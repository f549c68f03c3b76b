// The surface of a shape, exact.
#pragma once

#include "core/geometry/surface.hpp"

namespace abstand::geometry {

/// Everything in closed form (core/geometry/shape.hpp); hints are not needed.
class ShapeSurface final : public Surface {
 public:
  /// Throws UsageError for a shape that is not valid.
  explicit ShapeSurface(const Shape& shape);

  SurfacePoint closest(const Vector3d& p, std::uint32_t hint = kNoHint) const override;
  bool inside(const Vector3d& p) const override;
  bool inside(const Vector3d& p, const SurfacePoint& closest_to_p) const override;
  bool triangle(std::uint32_t, TriangleCorners&) const override { return false; }
  Bounds bounds() const override;
  MassProperties massProperties() const override;
  double area() const override;
  TriangleMesh mesh(double sagitta) const override;
  bool watertight() const override { return true; }
  const Shape* shape() const override { return &shape_; }

 private:
  Shape shape_;
};

}  // namespace abstand::geometry
