// Distances away from a body, certified from below.
#pragma once

#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand {

/// Nested coarse grids (each twice as wide and twice as coarse as the one before) that hold the squared
/// distance to the surface at their vertices. d^2 - |p|^2 is a minimum of affine functions, so it is concave,
/// and interpolating it never overestimates: d(p)^2 >= sum_i w_i d_i^2 - sum_axes h^2 t (1 - t).
/// So lowerBound() is a true lower bound of the unsigned distance, too small by at most about 3 h^2 / (8 d).
/// Level k reaches kMargin spacings of its own (or more) beyond the body's bounds, so that outside of the
/// levels before it d is at least kMargin / 2 spacings and the bound is within about 10 % of d. Beyond the
/// last grid: distance to its box plus the smallest distance on its boundary.
class FarField {
 public:
  static constexpr int kMargin = 4;

  FarField() = default;
  /// `reach`: how far from the body's bounds the grids go at least (m). `first_spacing` and `reach` are
  /// positive. Throws UsageError when the spacing is far too small for the body.
  FarField(const Surface& surface, double first_spacing, double reach, int threads = 0);

  /// Never above the true unsigned distance from p to the surface (float rounding allowed for). m. Any input
  /// is allowed; 0 for NaN and for an empty field.
  float lowerBound(float px, float py, float pz) const;
  std::size_t memoryBytes() const;
  template <class Archive>
  void archive(Archive& ar) {
    ar(levels_, box_lo_, box_hi_, boundary_min_);
  }

 private:
  struct Level {
    float ox, oy, oz;  ///< first vertex
    float inv_h, h;
    float rounding;         ///< m; how far float moves points of this level, at most
    int n[3];               ///< vertices along each axis
    std::vector<float> d2;  ///< rounded down
    template <class Archive>
    void archive(Archive& ar) {
      ar(ox, oy, oz, inv_h, h, rounding, n, d2);
    }
  };
  void fill(const Surface& surface, int threads);
  static float interpolate(const Level& level, float gx, float gy, float gz);

  std::vector<Level> levels_;
  float box_lo_[3]{}, box_hi_[3]{};
  float boundary_min_{0.0f};
};

}  // namespace abstand
