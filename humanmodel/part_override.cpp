// User overrides of one part.
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "humanmodel/body_plan.hpp"

namespace abstand::humanmodel {
namespace {

// Contains all parts of people between 0.5 and 2.5 m; excludes values in mm or cm.
constexpr double kSmallest = 0.005, kLargest = 3.0;

void checkSize(const std::optional<double>& value, std::string_view part, const char* what) {
  if (value && !(*value >= kSmallest && *value <= kLargest))
    throw UsageError(std::string(part) + "." + what + " is " + formatDouble(*value) + " m, expected " +
                     formatDouble(kSmallest) + " to " + formatDouble(kLargest));
}

}  // namespace

Segment overridden(const Segment& segment, const PartOverride& requested, std::string_view name) {
  checkSize(requested.length, name, "length");
  checkSize(requested.contour, name, "contour");
  checkSize(requested.breadth, name, "breadth");
  checkSize(requested.depth, name, "depth");

  Segment s = segment;
  if (requested.length) s.length = *requested.length;
  double contour = contourOf(s.shape, s.breadth, s.depth);
  if (requested.shape) {
    if (*requested.shape != "ellipsoid" && *requested.shape != "cuboid")
      throw UsageError(std::string(name) + ".shape is \"" + *requested.shape +
                       "\", expected ellipsoid or cuboid");
    s.shape = *requested.shape == "cuboid" ? PartShape::kCuboid : PartShape::kEllipsoid;
  }
  if (requested.contour) contour = *requested.contour;

  // Scaling breadth and depth together scales the girth by the same factor.
  const double scale = contour / contourOf(s.shape, s.breadth, s.depth);
  s.breadth *= scale;
  s.depth *= scale;
  if (requested.contour && requested.breadth && requested.depth)
    throw UsageError(std::string(name) +
                     ": contour, breadth and depth are given, expected two of them at most");
  if (requested.contour && (requested.breadth || requested.depth)) {
    const double given = requested.breadth ? *requested.breadth : *requested.depth;
    if (0.5 * contour - given < kSmallest)
      throw UsageError(std::string(name) + ": no cross-section is " + formatDouble(given) + " m wide and " +
                       formatDouble(contour) + " m around, expected a contour above twice the width");
    const double other = extentFor(s.shape, contour, given);
    s.breadth = requested.breadth ? given : other;
    s.depth = requested.breadth ? other : given;
  } else {
    if (requested.breadth) s.breadth = *requested.breadth;
    if (requested.depth) s.depth = *requested.depth;
  }
  return s;
}

}  // namespace abstand::humanmodel
