#include "tracking/tracker/seen_through.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/quantile.hpp"

namespace abstand::tracking {
namespace {

constexpr double kNearest = 0.3;     // m; no camera measures nearer surfaces
constexpr int kPointsOfRow = 80;     // that are compared
constexpr int kSearchedAcross = 40;  // pixels of the search about a point, along a side

/// m, across the ray at the depth of p_C: to the nearest pixel that does not see through there; what was not
/// measured may hide it. kFarthest: none is nearer.
double hiddenBeside(const LabelledImage& to, const Eigen::Vector2d& pixel, const Vector3d& p_C, double far) {
  const double per_pixel = p_C.z() / to.camera->fx;
  const int reach = static_cast<int>(SeenThrough::kFarthest / per_pixel);
  const int stride = std::max(1, 2 * reach / kSearchedAcross);
  const int u = static_cast<int>(pixel.x()), v = static_cast<int>(pixel.y());
  long nearest2 = std::numeric_limits<long>::max();  // pixels^2
  for (int y = std::max(0, v - reach); y <= std::min(to.image->height - 1, v + reach); y += stride)
    for (int x = std::max(0, u - reach); x <= std::min(to.image->width - 1, u + reach); x += stride)
      if (static_cast<double>(to.image->at(x, y)) < p_C.z() + far)
        nearest2 =
            std::min(nearest2, static_cast<long>(x - u) * (x - u) + static_cast<long>(y - v) * (y - v));
  return std::min(SeenThrough::kFarthest, std::sqrt(static_cast<double>(nearest2)) * per_pixel);
}

}  // namespace

double SeenThrough::displacement() const {
  return off.empty() ? 0.0 : nearestQuantile(off, kQuantile) / kQuantile;
}

void SeenThrough::add(const LabelledImage& from, const LabelledImage& to) {
  const Transform X_TF = to.camera->X_WC.inverse() * from.camera->X_WC;
  const int stride = std::max(1, from.image->width / kPointsOfRow);
  for (int v = stride / 2; v < from.image->height; v += stride) {
    for (int u = stride / 2; u < from.image->width; u += stride) {
      const double depth = from.image->at(u, v);
      if (depth <= 0.0 || from.labels[static_cast<std::size_t>(v * from.image->width + u)] == 0) continue;
      const Vector3d p_C = X_TF * from.camera->at(u, v, depth);
      if (p_C.z() < kNearest) continue;
      const Eigen::Vector2d pixel(to.camera->fx * p_C.x() / p_C.z() + to.camera->cx + 0.5,
                                  to.camera->fy * p_C.y() / p_C.z() + to.camera->cy + 0.5);
      if (!(pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < to.image->width &&
            pixel.y() < to.image->height))
        continue;
      const double z = to.image->at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
      if (z <= 0.0) continue;
      ++compared;
      const double far = farFrom(std::max(depth, p_C.z()));
      if (z < p_C.z() + far) continue;
      const double aside = hiddenBeside(to, pixel, p_C, far);
      if (aside > far) off.push_back(aside);
    }
  }
}

}  // namespace abstand::tracking
