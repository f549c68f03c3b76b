// By how much a part of a person may be elsewhere than it was seen: the rule that widens its margin.
#pragma once

#include <cmath>

#include "core/math/transform.hpp"

namespace abstand::humanmodel {

/// m/s; no part of a person is taken to be faster, where the scene says nothing: a hand [ISO 13855].
inline constexpr double kPersonSpeed = 2.0;
/// 99 % of the points of a normal distribution in space lie within so many standard deviations (those of one
/// axis) of its middle: the quantile of the chi distribution with three degrees of freedom.
inline constexpr double kSpreadQuantile = 3.3682;
/// m, each axis, of a joint that the tracker says it only guessed. Kinects put hidden joints some 0.05 to 0.1
/// m off (Obdrzalek et al. 2012, EMBC).
inline constexpr double kGuessedSpread = 0.05;

/// m: age (s since it was seen) times speed (m/s) plus the quantile times spread (m, standard deviation of an
/// axis). Infinite where one of them is, and for a number that is none: what is not known may be anywhere.
/// Never negative. No throw.
inline double partUncertainty(double age, double spread, double speed = kPersonSpeed) noexcept {
  const double moved = age > 0.0 ? age * speed : 0.0;
  const double uncertainty = moved + kSpreadQuantile * (spread > 0.0 ? spread : 0.0);
  const bool known = !std::isnan(age) && !std::isnan(spread) && !std::isnan(uncertainty);
  return known ? uncertainty : kInfinity;
}

}  // namespace abstand::humanmodel
