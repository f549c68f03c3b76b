// Seconds as colours.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/mesh_file/coloured_ply.hpp"

namespace abstand::report {

/// Eight classes whose borders are 1, 2 or 5 times a power of ten, the largest border at most the largest
/// value: seconds of exposure spread over several decades.
class HeatScale {
 public:
  static constexpr int kClasses = 8;

  /// `largest`: s; nothing above 0: a scale without classes.
  explicit HeatScale(double largest);

  bool empty() const { return borders_.empty(); }
  /// 0 to kClasses - 1, or -1 for no exposure.
  int classOf(double seconds) const;
  /// s, rising, kClasses - 1 of them.
  const std::vector<double>& borders() const { return borders_; }
  /// For meshes; grey for -1. Pages have the same colours in the classes h0 to h7, and others for dark pages.
  static mesh_file::Rgb colour(int heat_class);

  /// A row of boxes with their borders, from (0, 0) to the right, 34 pixels high, as a piece of SVG.
  std::string legend() const;

 private:
  std::vector<double> borders_;
};

}  // namespace abstand::report
