#include "humanmodel/held_tool.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::humanmodel {
namespace {

/// m, in increasing order.
std::array<double, 3> halfExtents(const HumanPart& part) {
  const Vector3d extent = 0.5 * geometry::bounds(part.bare).extent();
  std::array<double, 3> half{extent.x(), extent.y(), extent.z()};
  std::sort(half.begin(), half.end());
  return half;
}

}  // namespace

double turnLever(const HumanPart& hand) {
  const auto half = halfExtents(hand);
  return half[1] * half[2] / std::hypot(half[1], half[2]);
}

double heldUncertainty(double hand, double reach, double lever) noexcept {
  if (!(hand < kInfinity)) return kInfinity;
  return hand + reach * std::min(hand / lever, 2.0);
}

double bareRadius(const HumanPart& part) { return halfExtents(part).front(); }

}  // namespace abstand::humanmodel
