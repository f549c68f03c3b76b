#include "tracking/joint_guess/limb_choice.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr double kOddest = 25.0;
constexpr double kSkipped = 3.0;  // cost of a joint between the three that is left out, such as one for twist

/// Usual proportions of a limb, with the standard deviation of their logarithms: people differ by some 5 %,
/// conventions of skeletons by far more.
struct LimbShares {
  double upper_per_lower, upper_deviation;
  double start_per_upper, start_deviation;  ///< from the joint where the branch leaves to the first one
  double end_per_lower, end_deviation;      ///< from the last joint to the end of the branch
  double no_end;                            ///< cost of a limb that ends at its last joint
};
constexpr LimbShares kLegShares{1.0, 0.2, 0.4, 0.6, 0.6, 0.5, 2.0};
constexpr LimbShares kArmShares{0.186 / 0.146, 0.25, 0.8, 0.6, 0.6, 0.7, 1.0};

}  // namespace

double oddness(double value, double usual, double deviation) {
  if (!(value > 0.0)) return kOddest;
  const double off = std::log(value / usual) / deviation;
  return std::min(off * off, kOddest);
}

std::optional<LimbChoice> chooseLimb(const BranchPair& pair, LimbKind kind) {
  const LimbShares& usual = kind == LimbKind::kLeg ? kLegShares : kArmShares;
  const std::size_t n = pair.common;
  const auto along = [&](std::size_t i) { return 0.5 * (pair.a.along[i] + pair.b.along[i]); };
  std::optional<LimbChoice> best;
  for (std::size_t i = 0; i + 2 < n; ++i)
    for (std::size_t j = i + 1; j + 1 < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        LimbChoice c{i, j, k, along(j) - along(i), along(k) - along(j), 0.0};
        c.cost = oddness(c.upper / c.lower, usual.upper_per_lower, usual.upper_deviation) +
                 oddness(along(i) / c.upper, usual.start_per_upper, usual.start_deviation);
        const double end = (pair.length - along(k)) / c.lower;
        c.cost += kSkipped * static_cast<double>(k - i - 2);
        c.cost += end > 0.05 ? oddness(end, usual.end_per_lower, usual.end_deviation) : usual.no_end;
        if (!best || c.cost < best->cost) best = c;
      }
  return best;
}

}  // namespace abstand::tracking
