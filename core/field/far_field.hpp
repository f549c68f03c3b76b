// Certified lower bound of the distance from a body, on nested grids.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/surface.hpp"

namespace abstand::field {

/// Concentric grids with equal numbers of vertices, grid k being kRatio[k] times as wide and as coarse as the
/// first, which store lower bounds of the distance to the surface at their vertices. d^2 - |p|^2 is a minimum
/// of affine functions, hence concave, so interpolation of the squares never overestimates:
/// d(p)^2 >= sum_i w_i d_i^2 - sum_axes h^2 t (1 - t).
/// So lowerBound() is a lower bound of the unsigned distance. Its error depends on the surface: zero in front
/// of a vertex; in front of a plane, the sum over the axes except that of the distance. Grid k extends at
/// least kMargin of its own spacings beyond the body's bounds. Beyond the last grid, the distance to a ball
/// around the body is used. Constant after construction; any number of threads.
class FarField {
 public:
  static constexpr int kMargin = 6;
  static constexpr int kMaxLevels = 8;
  /// Width of each grid relative to the first.
  static constexpr float kRatio[kMaxLevels] = {1.0f, 2.0f, 8.0f, 32.0f, 128.0f, 512.0f, 2048.0f, 8192.0f};

  /// Data for queries, of one point or many at a time. Grid coordinates of p on level l are (p - centre)
  /// inv_h[l] + middle; value of vertex (i, j, k), in quanta: ((l n_z + k) n_y + j) n_x + i.
  struct View {
    float centre[3];
    float inv_half[3];  ///< 1 / half width of the first grid along each axis
    float middle[3];    ///< (n - 1) / 2
    int n[3];           ///< vertices along each axis, odd
    int levels;
    float width[kMaxLevels];     ///< kRatio; infinity after the last level
    float inv_h[kMaxLevels];     ///< 1 / spacing
    float h2[kMaxLevels];        ///< spacing squared
    float q2[kMaxLevels];        ///< squared quantum of the values
    float rounding[kMaxLevels];  ///< m; largest displacement of points of this level by rounding in float
    float outermost;             ///< kRatio of the last level
    float ball;                  ///< m, radius of a ball around the centre that contains the body
    const std::uint16_t* values;
    template <class Archive>
    void archive(Archive& ar) {
      ar(centre, inv_half, middle, n, levels, width, inv_h, h2, q2, rounding, outermost, ball);
    }
  };

  FarField() = default;
  /// `reach`: the grids extend at least this far beyond the body's bounds (m). `first_spacing` and `reach`
  /// are positive. Throws UsageError if the spacing is far too small for the body.
  FarField(const geometry::Surface& surface, double first_spacing, double reach, int threads = 0);

  /// Lower bound (m) of the unsigned distance from p to the surface, rounding in float included. Any input is
  /// allowed; 0 for NaN and for an empty field.
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

  // Relative rounding error of a sum of eight weighted products, and of the sum of squares.
  static constexpr float kSummed = 24.0f * 0x1p-23f;

 private:
  void setUpGrid(const geometry::Bounds& body, double first_spacing, double reach);
  void quantize(const std::vector<float>& distance);

  View view_{};
  std::vector<std::uint16_t> values_;  ///< distances in quanta, rounded down
};

}  // namespace abstand::field
