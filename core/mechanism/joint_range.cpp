#include "core/mechanism/joint_range.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::mechanism {
namespace {

constexpr double kUnlimitedSlide = 1.0;  // m to either side

JointRange rangeOf(const MechanismFrame& f) {
  JointRange range;
  const auto [a, b] =
      std::minmax({(f.limits.lower - f.offset) / f.scale, (f.limits.upper - f.offset) / f.scale});
  range.unlimited = !std::isfinite(a) || !std::isfinite(b);
  const double free = f.type == JointType::kPrismatic ? kUnlimitedSlide : kPi;
  // With a single limit, the range extends from it.
  range.lower = std::isfinite(a) ? a : std::isfinite(b) ? b - 2.0 * free : -free;
  range.upper = std::isfinite(b) ? b : range.lower + 2.0 * free;
  return range;
}

}  // namespace

std::vector<JointRange> jointRanges(const Mechanism& mechanism) {
  std::vector<JointRange> ranges(static_cast<std::size_t>(mechanism.dof));
  std::vector<bool> led(ranges.size(), false);
  for (const auto& f : mechanism.frames) {
    if (f.dof < 0) continue;
    const auto dof = static_cast<std::size_t>(f.dof);
    if (led[dof]) continue;
    ranges[dof] = rangeOf(f);
    led[dof] = !f.mimic;
  }
  return ranges;
}

void randomPosture(std::span<const JointRange> ranges, Random& random, std::span<double> q) {
  ABSTAND_CHECK(q.size() == ranges.size());
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = random.between(ranges[i].lower, ranges[i].upper);
}

}  // namespace abstand::mechanism
