// Position uncertainty of a part of a person; it widens the part's margin.
#pragma once

#include <cmath>

#include "core/math/transform.hpp"

namespace abstand::humanmodel {

/// m/s; assumed upper speed of a part if the scene states none: a hand [ISO 13855:2010].
inline constexpr double kPersonSpeed = 2.0;
/// 99 % quantile of the chi distribution with three degrees of freedom: 99 % of the points of an isotropic
/// normal distribution in space are within this many standard deviations (of one axis) of its mean.
inline constexpr double kSpreadQuantile = 3.3682;
/// m, standard deviation of each axis of a joint that the tracker marks as inferred. Kinects place hidden
/// joints wrongly by 0.05 to 0.1 m (Obdrzalek et al. 2012, EMBC).
inline constexpr double kGuessedSpread = 0.05;

/// m: age (s since last seen) times speed (m/s). 0 for ages that are not positive.
inline double ageUncertainty(double age, double speed = kPersonSpeed) noexcept {
  return age > 0.0 ? age * speed : 0.0;
}

/// m: age (s since last seen) times speed (m/s), plus kSpreadQuantile times spread (m, standard deviation of
/// an axis). Infinite if an argument is infinite or NaN. Never negative. No throw.
inline double partUncertainty(double age, double spread, double speed = kPersonSpeed) noexcept {
  const double uncertainty = ageUncertainty(age, speed) + kSpreadQuantile * (spread > 0.0 ? spread : 0.0);
  const bool known = !std::isnan(age) && !std::isnan(spread) && !std::isnan(uncertainty);
  return known ? uncertainty : kInfinity;
}

}  // namespace abstand::humanmodel
