// Perimeters of ellipses and rectangles.
#include "humanmodel/cross_section.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::humanmodel {

double contourOf(PartShape shape, double breadth, double depth) {
  if (shape == PartShape::kCuboid) return 2.0 * (breadth + depth);
  const double major = std::max(breadth, depth), minor = std::min(breadth, depth);
  // k^2 = 1 - (minor/major)^2 without cancellation for nearly round sections
  const double modulus = std::sqrt((major - minor) * (major + minor)) / major;
  return 2.0 * major * std::comp_ellint_2(modulus);
}

double extentFor(PartShape shape, double contour, double extent) {
  if (shape == PartShape::kCuboid) return 0.5 * contour - extent;
  // The perimeter of an ellipse increases with either axis, and an axis is at most half the perimeter.
  double low = 0.0, high = 0.5 * contour;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (contourOf(shape, extent, middle) < contour ? low : high) = middle;
  }
  return high;
}

}  // namespace abstand::humanmodel
