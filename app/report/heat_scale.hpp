// Colour scale for seconds.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/mesh_file/coloured_ply.hpp"

namespace abstand::report {

/// Eight classes with borders at 1, 2 or 5 times a power of ten, the largest border at most the largest
/// value: for exposures over several decades.
class HeatScale {
 public:
  static constexpr int kClasses = 8;

  /// `largest`: s; if not above 0: a scale without classes.
  explicit HeatScale(double largest);

  bool empty() const { return borders_.empty(); }
  /// 0 to kClasses - 1, or -1 for no exposure.
  int classOf(double seconds) const;
  /// s, increasing, kClasses - 1 values.
  const std::vector<double>& borders() const { return borders_; }
  /// Colour for meshes; grey for -1. Pages use the same colours in the classes h0 to h7, and others in dark
  /// mode.
  static mesh_file::Rgb colour(int heat_class);

  /// SVG fragment: a row of boxes with their borders, from (0, 0) to the right, 34 pixels high.
  std::string legend() const;

 private:
  std::vector<double> borders_;
};

}  // namespace abstand::report
