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

Segment overridden(const Segment& segment, const PartOverride& wish, std::string_view name) {
  checkSize(wish.length, name, "length");
  checkSize(wish.contour, name, "contour");
  checkSize(wish.breadth, name, "breadth");
  checkSize(wish.depth, name, "depth");

  Segment s = segment;
  if (wish.length) s.length = *wish.length;
  double contour = contourOf(s.shape, s.breadth, s.depth);
  if (wish.shape) {
    if (*wish.shape != "ellipsoid" && *wish.shape != "cuboid")
      throw UsageError(std::string(name) + ".shape is \"" + *wish.shape + "\", expected ellipsoid or cuboid");
    s.shape = *wish.shape == "cuboid" ? PartShape::kCuboid : PartShape::kEllipsoid;
  }
  if (wish.contour) contour = *wish.contour;

  // Scaling breadth and depth together scales the girth by the same factor.
  const double scale = contour / contourOf(s.shape, s.breadth, s.depth);
  s.breadth *= scale;
  s.depth *= scale;
  if (wish.contour && wish.breadth && wish.depth)
    throw UsageError(std::string(name) +
                     ": contour, breadth and depth are given, expected two of them at most");
  if (wish.contour && (wish.breadth || wish.depth)) {
    const double given = wish.breadth ? *wish.breadth : *wish.depth;
    if (0.5 * contour - given < kSmallest)
      throw UsageError(std::string(name) + ": no cross-section is " + formatDouble(given) + " m wide and " +
                       formatDouble(contour) + " m around, expected a contour above twice the width");
    const double other = extentFor(s.shape, contour, given);
    s.breadth = wish.breadth ? given : other;
    s.depth = wish.breadth ? other : given;
  } else {
    if (wish.breadth) s.breadth = *wish.breadth;
    if (wish.depth) s.depth = *wish.depth;
  }
  return s;
}

}  // namespace abstand::humanmodel
