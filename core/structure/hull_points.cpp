// Vertices of a convex hull as a structure of arrays, with its support function.
#include "core/structure/hull_points.hpp"

#include <algorithm>

#include "core/geometry/convex_hull.hpp"
#include "core/kernels/search_kernels.hpp"

namespace abstand::structure {
namespace {

// Share of the largest coordinate; far below kHullRounding.
constexpr double kOutside = 1e-12;
constexpr std::size_t kHullLanes = 8;
// Relative to the radius: rounding of points and directions to float, three products, two sums, and the
// store.
constexpr float kHullRounding = 8.0f * 0x1p-24f;

}  // namespace

std::vector<Vector3d> hullCorners(const std::vector<Vector3d>& points) {
  const std::optional<geometry::ConvexHull> hull = geometry::convexHull(points);
  double largest = 0.0;
  for (const Vector3d& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  if (!hull || hull->farthest_outside > kOutside * largest) return points;
  std::vector<Vector3d> corners;
  for (const std::uint32_t i : hull->corners) corners.push_back(points[i]);
  return corners;
}

HullPoints::HullPoints(const std::vector<Vector3d>& corners, const Vector3d& centre,
                       const geometry::Surface& surface)
    : centre_(centre) {
  for (const Vector3d& corner : corners) {
    const Vector3f p = (corner - centre).cast<float>();
    radius_ = std::max(radius_, p.norm());
    x_.push_back(p.x());
    y_.push_back(p.y());
    z_.push_back(p.z());
    hints_.push_back(surface.closest(corner).hint);
  }
  const auto pad = [](auto& v) {
    v.resize((v.size() + kHullLanes - 1) / kHullLanes * kHullLanes, v.back());
    v.shrink_to_fit();
  };
  pad(x_), pad(y_), pad(z_), pad(hints_);
}

float HullPoints::supportAboutCentre(const Vector3f& g) const {
  const float farthest =
      kernels::searchKernels().support({x_.data(), y_.data(), z_.data(), x_.size()}, g.x(), g.y(), g.z());
  return farthest + kHullRounding * g.lpNorm<1>() * radius_;
}

double HullPoints::support(const Vector3d& g) const {
  return g.dot(centre_) + static_cast<double>(supportAboutCentre(g.cast<float>()));
}

ExtremePoint HullPoints::extreme(const Vector3d& g) const {
  ExtremePoint extreme;
  farthest(g, extreme);
  return extreme;
}

double HullPoints::farthest(const Vector3d& g, ExtremePoint& extreme) const {
  const Vector3f d = g.cast<float>();
  const std::size_t i =
      kernels::searchKernels().extreme({x_.data(), y_.data(), z_.data(), x_.size()}, d.x(), d.y(), d.z());
  extreme = {centre_ + Vector3f(x_[i], y_[i], z_[i]).cast<double>(), hints_[i]};
  return g.dot(extreme.point) + 2.0 * static_cast<double>(kHullRounding * d.lpNorm<1>() * radius_);
}

}  // namespace abstand::structure
