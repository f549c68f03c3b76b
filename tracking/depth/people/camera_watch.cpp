#include "tracking/depth/people/camera_watch.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr int kColumns = 40;        // of the grid
constexpr int kSettled = 12;        // images
constexpr int kFewest = 20;         // cells of a third
constexpr double kNearFloor = 0.4;  // m

// A static depth is the mean of the first images, and then follows those that differ by noise slowly: the
// depths of a Kinect drift by centimetres within minutes, but a camera that is pushed in seconds is noticed.
constexpr int kOfMean = 60;                    // images
constexpr float kDrift = 1.0f / (60 * 30.0f);  // weight of a later image, of one minute at 30 Hz
constexpr float kSmooth = 0.3f;                // weight of the newest of the present depths

/// m; as PeopleFinder's: a Kinect's steps, twice.
float noiseAt(float z) { return 0.03f + 0.006f * z * z; }

/// m above the floor z = 0.
double heightAt(const DepthCamera& camera, int u, int v, float z) {
  return (camera.X_WC * camera.at(u, v, static_cast<double>(z))).z();
}

}  // namespace

CameraWatch::CameraWatch(const DepthCamera& camera)
    : camera_{camera},
      grid_(camera, std::max(1, camera.width / kColumns)),
      fit_(camera, grid_),
      cells_(grid_.size()),
      before_(grid_.size(), 0.0f),
      now_(grid_.size(), 0.0f) {}

/// Of a static cell.
void CameraWatch::learn(float z, Cell& cell) const {
  if (std::abs(z - cell.z) < noiseAt(z)) {
    cell.images = std::min(cell.images + 1, kOfMean);
    cell.z += (cell.images < kOfMean ? 1.0f / static_cast<float>(cell.images) : kDrift) * (z - cell.z);
    cell.others = 0;
    return;
  }
  const bool stands = std::abs(z - cell.other) < noiseAt(z);
  cell.others = stands ? cell.others + 1 : 1;
  if (!stands) cell.other = z;
  if (cell.others >= kSettlesAgain) cell = {.z = cell.other, .last = cell.last, .images = kSettled};
}

void CameraWatch::see(double t, const DepthImage& image, std::span<const std::uint8_t> is_person,
                      const DepthImage* known) {
  if (std::isfinite(moved_at_)) return;
  const bool is_first = !std::isfinite(last_t_);
  Counts counts;
  bool is_repeated = !is_first;
  std::size_t c = 0;
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns; ++column, ++c) {
      Cell& cell = cells_[c];
      const int x = grid_.pixelOf(column), y = grid_.pixelOf(row);
      const auto i = static_cast<std::size_t>(y * image.width + x);
      const float z = image.z[i];
      is_repeated = is_repeated && z == cell.last;
      cell.last = z;
      before_[c] = cell.images >= kSettled ? cell.z : 0.0f;
      const float smooth = now_[c];
      now_[c] = 0.0f;
      if (z <= 0.0f || (is_person[i] != 0 && heightAt(camera_, x, y, z) > kNearFloor)) continue;
      if (known && known->z[i] > 0.0f && z > known->z[i] - noiseAt(z)) continue;
      if (cell.images < kSettled) {
        if (std::abs(z - cell.z) < noiseAt(z))
          cell.z += (z - cell.z) / static_cast<float>(++cell.images);
        else
          cell = {.z = z, .last = z, .images = 1};
        continue;
      }
      const std::size_t third = grid_.thirdOf(column);
      ++counts.settled[third];
      counts.differ[third] += std::abs(z - cell.z) >= noiseAt(z);
      now_[c] = std::abs(z - smooth) < noiseAt(z) ? smooth + kSmooth * (z - smooth) : z;
      learn(z, cell);
    }
  }
  repeated_ += is_repeated;
  unchanged_since_ = is_repeated ? std::min(unchanged_since_, last_t_) : kInfinity;
  last_t_ = t;
  if (!hasMoved(counts)) {
    differs_since_ = kInfinity;
    return;
  }
  differs_since_ = std::min(differs_since_, t);
  if (t - differs_since_ >= kLasts) moved_at_ = differs_since_;
}

bool CameraWatch::Counts::haveMoved() const {
  for (std::size_t k = 0; k < settled.size(); ++k)
    if (settled[k] < kFewest || differ[k] <= kMovedShare * settled[k]) return false;
  return true;
}

bool CameraWatch::hasMoved(const Counts& counts) {
  if (counts.haveMoved()) return true;
  const std::optional<CameraMotion> motion = fit_.estimate(before_, now_);
  return motion && motion->displacement >= kMoved;
}

}  // namespace abstand::tracking
