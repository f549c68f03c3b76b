// One image of a depth camera.
#pragma once

#include <cstddef>
#include <vector>

namespace abstand::tracking {

/// Depths (m) along the optical axis, row by row from the top; 0: no measurement.
struct DepthImage {
  int width{0}, height{0};
  std::vector<float> z;

  DepthImage() = default;
  DepthImage(int w, int h)
      : width(w), height(h), z(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0.0f) {}
  float& at(int u, int v) {
    return z[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)];
  }
  float at(int u, int v) const {
    return z[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)];
  }
};

}  // namespace abstand::tracking
