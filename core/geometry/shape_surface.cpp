// The surface of a shape, exact.
#include "core/geometry/shape_surface.hpp"

#include <cmath>

namespace abstand::geometry {

ShapeSurface::ShapeSurface(const Shape& shape) : shape_(shape) { validate(shape); }

SurfacePoint ShapeSurface::closest(const Vector3d& p, std::uint32_t) const {
  const ShapeDistance d = distanceTo(shape_, p);
  // The hint stores the side, so that inside() does not compute it again.
  return {d.nearest, std::abs(d.distance), d.distance < 0.0 ? 1u : 0u};
}

bool ShapeSurface::inside(const Vector3d& p) const { return distanceTo(shape_, p).distance < 0.0; }
bool ShapeSurface::inside(const Vector3d&, const SurfacePoint& closest_to_p) const {
  return closest_to_p.hint == 1u;
}
Bounds ShapeSurface::bounds() const { return abstand::geometry::bounds(shape_); }
MassProperties ShapeSurface::massProperties() const { return abstand::geometry::massProperties(shape_); }
double ShapeSurface::area() const { return surfaceArea(shape_); }
TriangleMesh ShapeSurface::mesh(double sagitta) const { return tessellate(shape_, sagitta); }

std::unique_ptr<Surface> makeSurface(const Shape& shape) { return std::make_unique<ShapeSurface>(shape); }

}  // namespace abstand::geometry
