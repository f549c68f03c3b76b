// The cheapest fits, and how far their joints are apart.
#include "tracking/tracker/alike_fits.hpp"

#include <algorithm>
#include <span>

namespace abstand::tracking {

void AlikeFits::add(double cost, const RigPlacement& X_WS) {
  std::size_t k = count_;
  if (count_ < kMax) {
    ++count_;
  } else {
    const auto dearest = std::max_element(fits_.begin(), fits_.end(),
                                          [](const Fit& a, const Fit& b) { return a.cost < b.cost; });
    if (dearest->cost <= cost) return;
    k = static_cast<std::size_t>(dearest - fits_.begin());
  }
  fits_[k].cost = cost;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    fits_[k].p[j] = jointPosition(*rig_, X_WS, static_cast<humanmodel::Joint>(j));
}

JointRadii AlikeFits::apart() const {
  JointRadii apart{};
  const auto fits = std::span(fits_).first(count_);
  const auto best =
      std::min_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.cost < b.cost; });
  for (const Fit& fit : fits) {
    if (&fit == &*best || fit.cost >= kAlike * best->cost) continue;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      const double distance = (fit.p[j] - best->p[j]).norm();
      apart[j] = std::max(apart[j], distance > kOwnError ? distance + kOwnError : distance);
    }
  }
  return apart;
}

}  // namespace abstand::tracking
