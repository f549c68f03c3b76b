// Support function of a body's convex hull.
#include "core/structure/support_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace abstand::structure {
namespace {

/// h(g) of each shape, exact up to rounding in double.
struct ShapeSupport {
  const Vector3d& g;
  double operator()(const geometry::Sphere& s) const { return s.radius * g.norm(); }
  double operator()(const geometry::Ellipsoid& s) const { return s.semi_axes.cwiseProduct(g).norm(); }
  double operator()(const geometry::Cuboid& s) const { return 0.5 * s.size.dot(g.cwiseAbs()); }
  double operator()(const geometry::Cylinder& s) const {
    return s.radius * std::hypot(g.x(), g.y()) + 0.5 * s.length * std::abs(g.z());
  }
  double operator()(const geometry::Capsule& s) const {
    return s.radius * g.norm() + 0.5 * s.length * std::abs(g.z());
  }
};

/// A point with the largest g . p.
struct ShapeExtreme {
  const Vector3d& g;
  Vector3d operator()(const geometry::Sphere& s) const { return s.radius * g.normalized(); }
  Vector3d operator()(const geometry::Ellipsoid& s) const {
    const Vector3d stretched = s.semi_axes.cwiseProduct(g);
    return s.semi_axes.cwiseProduct(stretched) / stretched.norm();
  }
  Vector3d operator()(const geometry::Cuboid& s) const {
    return 0.5 * Vector3d(std::copysign(s.size.x(), g.x()), std::copysign(s.size.y(), g.y()),
                          std::copysign(s.size.z(), g.z()));
  }
  Vector3d operator()(const geometry::Cylinder& s) const {
    const double across = std::hypot(g.x(), g.y());
    const double r = across > 0.0 ? s.radius / across : 0.0;
    // For g along the axis, any point of the rim.
    return {across > 0.0 ? r * g.x() : s.radius, r * g.y(), std::copysign(0.5 * s.length, g.z())};
  }
  Vector3d operator()(const geometry::Capsule& s) const {
    return s.radius * g.normalized() + Vector3d(0.0, 0.0, std::copysign(0.5 * s.length, g.z()));
  }
};

/// Direction through the corner (u, v) of a face of the cube [-1, 1]^3.
Vector3f corner(int face, float u, float v) {
  const int axis = face / 2;
  Vector3f g;
  g[axis] = face % 2 == 0 ? 1.0f : -1.0f;
  g[(axis + 1) % 3] = u;
  g[(axis + 2) % 3] = v;
  return g;
}

float along(int i) { return 2.0f * static_cast<float>(i) / SupportMap::kCells - 1.0f; }

}  // namespace

SupportMap::SupportMap(const geometry::Surface& surface, const geometry::TriangleMesh& mesh,
                       const Vector3d& centre, int threads) {
  setShape(surface);
  if (shape_) return;
  hull_ = HullPoints(hullCorners(mesh.vertices), centre, surface);
  values_.resize(6 * kCorners * kCorners);
  parallelFor(threads, 6 * kCorners, [&](std::size_t row) {
    const int face = static_cast<int>(row) / kCorners, j = static_cast<int>(row) % kCorners;
    for (int i = 0; i < kCorners; ++i) {
      const Vector3f g = corner(face, along(i), along(j));
      values_[row * kCorners + static_cast<std::size_t>(i)] = hull_.supportAboutCentre(g);
    }
  });
}

void SupportMap::setShape(const geometry::Surface& surface) {
  if (const geometry::Shape* shape = surface.shape()) shape_ = *shape;
}

double SupportMap::closeUpper(const Vector3d& g) const {
  if (shape_) return std::visit(ShapeSupport{g}, *shape_);
  return hull_.support(g);
}

ExtremePoint SupportMap::extreme(const Vector3d& g) const {
  if (shape_) return {std::visit(ShapeExtreme{g}, *shape_), geometry::kNoHint};
  return hull_.extreme(g);
}

double SupportMap::farthest(const Vector3d& g, ExtremePoint& extreme) const {
  if (!shape_) return hull_.farthest(g, extreme);
  extreme = this->extreme(g);
  return closeUpper(g);
}

double SupportMap::upper(const Vector3d& g) const {
  if (shape_) return std::visit(ShapeSupport{g}, *shape_);
  // Selects the face of the cube without an unpredictable branch.
  const double x = std::abs(g.x()), y = std::abs(g.y()), z = std::abs(g.z());
  const int axis = z > std::max(x, y) ? 2 : static_cast<int>(y > x);
  const double length = std::max({x, y, z});
  const int u_axis = axis == 2 ? 0 : axis + 1, v_axis = axis == 0 ? 2 : axis - 1;
  const int face = 2 * axis + (g[axis] > 0.0 ? 0 : 1);
  // Cells along the face, from 0 to kCells.
  const double scale = 0.5 * kCells / length;
  const double u = g[u_axis] * scale + 0.5 * kCells, v = g[v_axis] * scale + 0.5 * kCells;
  const int i = std::clamp(static_cast<int>(u), 0, kCells - 1),
            j = std::clamp(static_cast<int>(v), 0, kCells - 1);
  const double s = u - i, t = v - j;
  const float* h = &values_[static_cast<std::size_t>((face * kCorners + j) * kCorners + i)];
  const double low = h[0] + s * (h[1] - h[0]), high = h[kCorners] + s * (h[kCorners + 1] - h[kCorners]);
  return g.dot(hull_.centre()) + length * (low + t * (high - low));
}

}  // namespace abstand::structure
