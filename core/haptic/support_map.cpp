// How far a body reaches in a direction: the support function of its convex hull.
#include "core/haptic/support_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/geometry/convex_hull.hpp"
#include "core/haptic/search_kernels.hpp"

namespace abstand {
namespace {

// Relative to the radius: points and directions in float, three products and two sums, and storing.
// Of the largest coordinate; far below kRounding.
constexpr double kOutside = 1e-12;
constexpr std::size_t kLanes = 8;
constexpr float kRounding = 8.0f * 0x1p-24f;

/// h(g) of each shape, exact to rounding of double.
struct ShapeSupport {
  const Vector3d& g;
  double operator()(const Sphere& s) const { return s.radius * g.norm(); }
  double operator()(const Ellipsoid& s) const { return s.semi_axes.cwiseProduct(g).norm(); }
  double operator()(const Cuboid& s) const { return 0.5 * s.size.dot(g.cwiseAbs()); }
  double operator()(const Cylinder& s) const {
    return s.radius * std::hypot(g.x(), g.y()) + 0.5 * s.length * std::abs(g.z());
  }
  double operator()(const Capsule& s) const { return s.radius * g.norm() + 0.5 * s.length * std::abs(g.z()); }
};

/// A point where g . p is largest.
struct ShapeExtreme {
  const Vector3d& g;
  Vector3d operator()(const Sphere& s) const { return s.radius * g.normalized(); }
  Vector3d operator()(const Ellipsoid& s) const {
    const Vector3d stretched = s.semi_axes.cwiseProduct(g);
    return s.semi_axes.cwiseProduct(stretched) / stretched.norm();
  }
  Vector3d operator()(const Cuboid& s) const {
    return 0.5 * Vector3d(std::copysign(s.size.x(), g.x()), std::copysign(s.size.y(), g.y()),
                          std::copysign(s.size.z(), g.z()));
  }
  Vector3d operator()(const Cylinder& s) const {
    const double across = std::hypot(g.x(), g.y());
    const double r = across > 0.0 ? s.radius / across : 0.0;
    // Straight up, any point of the rim.
    return {across > 0.0 ? r * g.x() : s.radius, r * g.y(), std::copysign(0.5 * s.length, g.z())};
  }
  Vector3d operator()(const Capsule& s) const {
    return s.radius * g.normalized() + Vector3d(0.0, 0.0, std::copysign(0.5 * s.length, g.z()));
  }
};

/// The corners of the mesh's hull; all of its vertices where there is no telling.
std::vector<Vector3d> hullCorners(const TriangleMesh& mesh) {
  const std::optional<ConvexHull> hull = convexHull(mesh.vertices);
  double largest = 0.0;
  for (const Vector3d& p : mesh.vertices) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  if (!hull || hull->farthest_outside > kOutside * largest) return mesh.vertices;
  std::vector<Vector3d> corners;
  for (const std::uint32_t i : hull->corners) corners.push_back(mesh.vertices[i]);
  return corners;
}

/// The direction through the corner (u, v) of a face of the cube [-1, 1]^3.
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

SupportMap::SupportMap(const Surface& surface, const TriangleMesh& mesh, const Vector3d& centre,
                       int threads) {
  setShape(surface);
  if (shape_) return;
  centre_ = centre;
  for (const Vector3d& vertex : hullCorners(mesh)) {
    const Vector3f p = (vertex - centre).cast<float>();
    radius_ = std::max(radius_, p.norm());
    x_.push_back(p.x());
    y_.push_back(p.y());
    z_.push_back(p.z());
  }
  for (std::vector<float>* v : {&x_, &y_, &z_})
    v->resize((v->size() + kLanes - 1) / kLanes * kLanes, v->back());
  values_.resize(6 * kCorners * kCorners);
  parallelFor(threads, 6 * kCorners, [&](std::size_t row) {
    const int face = static_cast<int>(row) / kCorners, j = static_cast<int>(row) % kCorners;
    for (int i = 0; i < kCorners; ++i) {
      const Vector3f g = corner(face, along(i), along(j));
      values_[row * kCorners + static_cast<std::size_t>(i)] = reach(g);
    }
  });
}

void SupportMap::setShape(const Surface& surface) {
  if (const Shape* shape = surface.shape()) shape_ = *shape;
}

float SupportMap::reach(const Vector3f& g) const {
  const float farthest =
      searchKernels().support(x_.data(), y_.data(), z_.data(), x_.size(), g.x(), g.y(), g.z());
  return farthest + kRounding * g.lpNorm<1>() * radius_;
}

double SupportMap::closeUpper(const Vector3d& g) const {
  if (shape_) return std::visit(ShapeSupport{g}, *shape_);
  return g.dot(centre_) + static_cast<double>(reach(g.cast<float>()));
}

Vector3d SupportMap::extreme(const Vector3d& g) const {
  if (shape_) return std::visit(ShapeExtreme{g}, *shape_);
  const Vector3f d = g.cast<float>();
  const std::size_t i =
      searchKernels().extreme(x_.data(), y_.data(), z_.data(), x_.size(), d.x(), d.y(), d.z());
  return centre_ + Vector3f(x_[i], y_[i], z_[i]).cast<double>();
}

double SupportMap::upper(const Vector3d& g) const {
  if (shape_) return std::visit(ShapeSupport{g}, *shape_);
  int axis;
  const double length = g.cwiseAbs().maxCoeff(&axis);
  const int face = 2 * axis + (g[axis] > 0.0 ? 0 : 1);
  // Cells along the face, from 0 to kCells.
  const double scale = 0.5 * kCells / length;
  const double u = g[(axis + 1) % 3] * scale + 0.5 * kCells, v = g[(axis + 2) % 3] * scale + 0.5 * kCells;
  const int i = std::clamp(static_cast<int>(u), 0, kCells - 1),
            j = std::clamp(static_cast<int>(v), 0, kCells - 1);
  const double x = u - i, y = v - j;
  const float* h = &values_[static_cast<std::size_t>((face * kCorners + j) * kCorners + i)];
  const double low = h[0] + x * (h[1] - h[0]), high = h[kCorners] + x * (h[kCorners + 1] - h[kCorners]);
  return g.dot(centre_) + length * (low + y * (high - low));
}

}  // namespace abstand
