#include "tracking/tracker/displaced_things.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr int kOfRow = 110;  // points of the things that are compared
constexpr int kAcross = 36;  // points of the search around one of them, along a side
constexpr double kStampsInRadius =
    4.0;  // discs along an edge: less than 1 % of the radius is missing between two

/// Distance (m) of the rendered point at (u, v) from the nearest of some measured ones; kFarthest: none is
/// nearer.
double nearestOf(const DepthImage& image, const DepthCamera& camera, int u, int v, double depth) {
  const Vector3d p_C = camera.at(u, v, depth);
  const double radius = DisplacedThings::kFarthest * camera.fx / depth;  // pixels
  const int stride = std::max(1, static_cast<int>(2.0 * radius) / kAcross);
  const int reach = static_cast<int>(radius) / stride * stride;
  double nearest = DisplacedThings::kFarthest * DisplacedThings::kFarthest;
  for (int dv = -reach; dv <= reach; dv += stride) {
    for (int du = -reach; du <= reach; du += stride) {
      const int x = u + du, y = v + dv;
      if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
      const double z = image.at(x, y);
      if (z > 0.0) nearest = std::min(nearest, (camera.at(x, y, z) - p_C).squaredNorm());
    }
  }
  return std::sqrt(nearest);
}

}  // namespace

bool DisplacedThings::add(const DepthImage& image, const DepthImage& known, const DepthCamera& camera,
                          double kept) {
  ABSTAND_CHECK(known.z.size() == image.z.size());
  const int stride = std::max(1, image.width / kOfRow);
  bool is_first = true;
  for (int v = 0; v < image.height; v += stride) {
    for (int u = 0; u < image.width; u += stride) {
      const double depth = known.at(u, v), z = image.at(u, v);
      if (depth <= 0.0 || z <= 0.0 || z < depth - kFarthest) continue;
      if (is_first) forget(kept);
      is_first = false;
      const double distance = nearestOf(image, camera, u, v, depth);
      points_ += 1.0;
      depths_ += depth;
      if (distance < kFarthest)
        near_[std::min(static_cast<std::size_t>(distance / kFarthest * kBins), kBins - 1)] += 1.0;
    }
  }
  return !is_first;
}

void DisplacedThings::forget(double kept) {
  for (double& bin : near_) bin *= kept;
  points_ *= kept;
  depths_ *= kept;
}

double DisplacedThings::share() const {
  double near = 0.0;
  for (const double bin : near_) near += bin;
  return points_ > 0.0 ? near / points_ : kNaN;
}

double DisplacedThings::displacement() const {
  double near = 0.0, sum = 0.0;
  for (const double bin : near_) near += bin;
  for (std::size_t k = 0; k < kBins && near > 0.0; ++k) {
    if (sum + near_[k] < kQuantile * near) {
      sum += near_[k];
      continue;
    }
    const double inside = (kQuantile * near - sum) / near_[k];
    return (static_cast<double>(k) + inside) * kFarthest / kBins / kQuantile;
  }
  return 0.0;
}

double DisplacedThings::band() const {
  if (!(points_ >= kFewest) || displacement() <= noiseAt(depths_ / points_)) return 0.0;
  return displacement() + kMargin;
}

const DepthImage& BandedThings::around(const DepthImage& known, const DepthCamera& camera, double band) {
  if (!(band > 0.0)) return known;
  banded_ = known;
  for (float& z : banded_.z)
    if (z > 0.0f) z = std::max(z - static_cast<float>(band), 0.01f);
  // A disc around every pixel would be the same, and slower: those inside are covered by the edge's.
  for (int v = 0; v < known.height; ++v) {
    for (int u = 0; u < known.width; ++u) {
      const float z = known.at(u, v);
      if (z <= 0.0f) continue;
      const double radius = band * camera.fx / static_cast<double>(z);  // pixels
      const int between = std::max(1, static_cast<int>(radius / kStampsInRadius));
      if (u % between != 0 && v % between != 0) continue;
      const auto isEdge = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= known.width || y >= known.height) return false;
        const float other = known.at(x, y);
        return other <= 0.0f || other > z + static_cast<float>(band);
      };
      if (isEdge(u - 1, v) || isEdge(u + 1, v) || isEdge(u, v - 1) || isEdge(u, v + 1))
        stamp(known, camera, u, v, band);
    }
  }
  return banded_;
}

/// A ball around the point at (u, v).
void BandedThings::stamp(const DepthImage& known, const DepthCamera& camera, int u, int v, double band) {
  const double depth = known.at(u, v), radius = band * camera.fx / depth;  // pixels
  const int reach = static_cast<int>(std::ceil(radius));
  for (int y = std::max(0, v - reach); y <= std::min(known.height - 1, v + reach); ++y) {
    for (int x = std::max(0, u - reach); x <= std::min(known.width - 1, u + reach); ++x) {
      const double aside = ((x - u) * (x - u) + (y - v) * (y - v)) / (radius * radius);
      if (aside > 1.0) continue;
      const auto nearest = static_cast<float>(std::max(depth - band * std::sqrt(1.0 - aside), 0.01));
      float& z = banded_.z[static_cast<std::size_t>(y * known.width + x)];
      if (z <= 0.0f || nearest < z) z = nearest;
    }
  }
}

}  // namespace abstand::tracking
