// Depth images of upright plates, and what a camera needs to see them.
#pragma once

#include <cmath>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"
#include "tracking/depth/people/floor_plane.hpp"
#include "tracking/depth/people/plan_view.hpp"

namespace abstand::testing {

/// Plates that face a level camera, 1 m above the floor; behind them a wall at 4 m, on which nothing stands.
class PaintedImage {
 public:
  static constexpr double kHeight = 1.0, kWall = 4.0;  // m

  PaintedImage() {
    camera_.width = 160;
    camera_.height = 120;
    camera_.fx = camera_.fy = 100.0;
    camera_.cx = 79.5;
    camera_.cy = 59.5;
    floor_ = {-Vector3d::UnitY(), kHeight};
    clear();
  }
  void clear() {
    image_ = tracking::DepthImage(camera_.width, camera_.height);
    std::fill(image_.z.begin(), image_.z.end(), static_cast<float>(kWall));
    labels_.assign(image_.z.size(), 0);
    cells_.assign(image_.z.size(), -1);
  }
  /// From `left` to `right` (m, of the camera's middle), `low` to `high` (m above the floor), at depth `z`;
  /// label 1 if `of_person`. Later plates hide earlier ones only if they are nearer.
  void plate(double left, double right, double low, double high, double z, bool of_person = true) {
    for (int v = 0; v < camera_.height; ++v)
      for (int u = 0; u < camera_.width; ++u) {
        const double x = (u - camera_.cx) / camera_.fx * z, h = kHeight - (v - camera_.cy) / camera_.fy * z;
        const std::size_t i = pixel(u, v);
        if (x < left || x >= right || h < low || h >= high || image_.z[i] < static_cast<float>(z)) continue;
        image_.z[i] = static_cast<float>(z);
        labels_[i] = of_person;
        cells_[i] = of_person ? tracking::PlanView::cellAt(x, z) : -1;
      }
  }
  /// Whose trunk is at (0, 2.5): somebody 1.75 m tall who stands.
  void person() {
    plate(-0.09, 0.09, 1.45, 1.75, 2.5);
    plate(-0.22, 0.22, 0.80, 1.46, 2.5);
    plate(-0.20, -0.04, 0.03, 0.81, 2.5);
    plate(0.04, 0.20, 0.03, 0.81, 2.5);
  }
  std::size_t pixel(int u, int v) const { return static_cast<std::size_t>(v * camera_.width + u); }
  /// Of a point at `x` (m, of the camera's middle), `h` (m above the floor) and depth `z` (m).
  std::size_t pixelOf(double x, double h, double z) const {
    return pixel(static_cast<int>(std::lround(camera_.cx + camera_.fx * x / z)),
                 static_cast<int>(std::lround(camera_.cy + camera_.fy * (kHeight - h) / z)));
  }

  const tracking::DepthCamera& camera() const { return camera_; }
  const tracking::FloorPlane& floor() const { return floor_; }
  tracking::DepthImage& image() { return image_; }
  std::vector<std::uint8_t>& labels() { return labels_; }
  const std::vector<int>& cells() const { return cells_; }

 private:
  tracking::DepthCamera camera_;
  tracking::FloorPlane floor_;
  tracking::DepthImage image_;
  std::vector<std::uint8_t> labels_;
  std::vector<int> cells_;
};

}  // namespace abstand::testing
