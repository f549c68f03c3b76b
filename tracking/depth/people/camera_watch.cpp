#include "tracking/depth/people/camera_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr int kStep = 8;      // pixels
constexpr int kSettled = 12;  // images
constexpr int kFewest = 20;   // cells of a third
constexpr int kThirds = 3;
constexpr double kNearFloor = 0.4;  // m
constexpr float kRenew = 0.1f;      // weight of the newest depth

/// m; as PeopleFinder's: a Kinect's steps, twice.
float noiseAt(float z) { return 0.03f + 0.006f * z * z; }

/// m above the floor z = 0.
double heightAt(const DepthCamera& camera, int u, int v, float z) {
  const Vector3d p_C((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  return (camera.X_WC * Vector3d(static_cast<double>(z) * p_C)).z();
}

}  // namespace

void CameraWatch::see(double t, const DepthImage& image, std::span<const std::uint8_t> is_person,
                      const DepthImage* known) {
  if (std::isfinite(moved_at_)) return;
  const bool is_first = cells_.empty();
  cells_.resize(static_cast<std::size_t>((image.width / kStep) * (image.height / kStep)));
  std::array<int, kThirds> settled{}, differ{};
  bool is_repeated = !is_first;
  std::size_t c = 0;
  for (int v = 0; v < image.height / kStep; ++v) {
    for (int u = 0; u < image.width / kStep; ++u, ++c) {
      Cell& cell = cells_[c];
      const int x = u * kStep + kStep / 2, y = v * kStep + kStep / 2;
      const auto i = static_cast<std::size_t>(y * image.width + x);
      const float z = image.z[i];
      is_repeated = is_repeated && z == cell.last;
      cell.last = z;
      if (z <= 0.0f || (is_person[i] != 0 && heightAt(camera_, x, y, z) > kNearFloor)) continue;
      if (known && known->z[i] > 0.0f && z > known->z[i] - noiseAt(z)) continue;
      const bool is_same = std::abs(z - cell.z) < noiseAt(z);
      if (cell.images >= kSettled) {
        const auto third = static_cast<std::size_t>(x * kThirds / image.width);
        ++settled[third];
        differ[third] += !is_same;
        if (is_same) cell.z += kRenew * (z - cell.z);
      } else if (is_same) {
        ++cell.images;
      } else {
        cell = {z, z, 1};
      }
    }
  }
  repeated_ += is_repeated;
  unchanged_since_ = is_repeated ? std::min(unchanged_since_, last_t_) : kInfinity;
  last_t_ = t;
  bool has_moved = true;
  for (std::size_t k = 0; k < kThirds; ++k)
    has_moved = has_moved && settled[k] >= kFewest && differ[k] > kMovedShare * settled[k];
  if (!has_moved) {
    differs_since_ = kInfinity;
    return;
  }
  differs_since_ = std::min(differs_since_, t);
  if (t - differs_since_ >= kLasts) moved_at_ = differs_since_;
}

}  // namespace abstand::tracking
