// Scatter of the points.
#include "tracking/tracker/longest_extent.hpp"

#include <cmath>

namespace abstand::tracking {

double longestExtent(const SeenPoints& points, const Vector3d& middle) {
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < points.count; ++i) {
    const Eigen::Vector2d off = (points.point(i) - middle).head<2>();
    scatter += off * off.transpose();
  }
  // Direction of the larger eigenvalue.
  return 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
}

}  // namespace abstand::tracking
