// Distances away from a body, certified from below.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::field {

/// Grids about one centre, all of the same number of vertices and each some times as wide and as coarse as
/// the one before (kRatio), that hold the distance to the surface at their vertices. d^2 - |p|^2 is a minimum
/// of affine functions, so it is concave, and interpolating the squares never overestimates:
/// d(p)^2 >= sum_i w_i d_i^2 - sum_axes h^2 t (1 - t).
/// So lowerBound() is a true lower bound of the unsigned distance. How much it loses depends on the surface:
/// nothing where the nearest point is a tip, sum_axes without the axis of the distance where it is a plane.
/// Grid k reaches kMargin spacings of its own (or more) beyond the body's bounds. Beyond the last: the
/// distance to a ball about the body. Constant after construction; any number of threads.
class FarField {
 public:
  static constexpr int kMargin = 6;
  static constexpr int kMaxLevels = 8;
  /// Width of each grid in widths of the first.
  static constexpr float kRatio[kMaxLevels] = {1.0f, 2.0f, 8.0f, 32.0f, 128.0f, 512.0f, 2048.0f, 8192.0f};

  /// What a query reads, for one point or many at a time. Grid coordinates of p on level l are
  /// (p - centre) inv_h[l] + middle; values of vertex (i, j, k): ((l n_z + k) n_y + j) n_x + i, in quanta.
  struct View {
    float centre[3];
    float inv_half[3];  ///< 1 / half width of the first grid along each axis
    float middle[3];    ///< (n - 1) / 2
    int n[3];           ///< vertices along each axis, odd
    int levels;
    float width[kMaxLevels];     ///< kRatio, infinity from the last level on
    float inv_h[kMaxLevels];     ///< 1 / spacing
    float h2[kMaxLevels];        ///< spacing squared
    float q2[kMaxLevels];        ///< squared quantum of the values
    float rounding[kMaxLevels];  ///< m; how far float moves points of this level, at most
    float outermost;             ///< kRatio of the last level
    float ball;                  ///< m, radius of a ball about the centre that holds the body
    const std::uint16_t* values;
    template <class Archive>
    void archive(Archive& ar) {
      ar(centre, inv_half, middle, n, levels, width, inv_h, h2, q2, rounding, outermost, ball);
    }
  };

  FarField() = default;
  /// `reach`: how far from the body's bounds the grids go at least (m). `first_spacing` and `reach` are
  /// positive. Throws UsageError when the spacing is far too small for the body.
  FarField(const geometry::Surface& surface, double first_spacing, double reach, int threads = 0);

  /// Never above the true unsigned distance from p to the surface (float rounding allowed for). m. Any input
  /// is allowed; 0 for NaN and for an empty field.
  float lowerBound(float px, float py, float pz) const;
  View view() const {
    View v = view_;
    v.values = values_.data();
    return v;
  }
  bool empty() const { return values_.empty(); }
  std::size_t memoryBytes() const { return values_.capacity() * sizeof(std::uint16_t); }

  template <class Archive>
  void archive(Archive& ar) {
    ar(view_, values_);
  }

  // Relative: a sum of eight products with their weights, and that of the squares.
  static constexpr float kSummed = 24.0f * 0x1p-23f;

 private:
  void layOut(const geometry::Bounds& body, double first_spacing, double reach);
  void keepQuanta(const std::vector<float>& distance);

  View view_{};
  std::vector<std::uint16_t> values_;  ///< distances in quanta, rounded down
};

}  // namespace abstand::field
