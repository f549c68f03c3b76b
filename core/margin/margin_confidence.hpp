// Statistical confidence of a margin derived from recordings.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace abstand::margin {

/// Upper confidence limit of the share of unseen recordings that violate a margin which none of `count`
/// recordings violated, at level `confidence`: 1 - (1 - confidence)^(1 / count), about 3 / count at 95 %
/// ("rule of three", Hanley and Lippman-Hand 1983). Also valid for the largest of the recordings' own values
/// (order statistics, Wilks 1941). Assumes independent recordings of one distribution. 1 for no recording.
double unseenShare(std::size_t count, double confidence = 0.95);

/// Upper confidence limit of the rate of violations, per unit of `time`, of a margin that nothing in `time`
/// violated, at level `confidence`: -ln(1 - confidence) / time, about 3 / time at 95 % (rule of three).
/// Model: stretches that need a larger margin occur as a Poisson process of constant rate, so that times
/// which do not overlap are independent. Also valid for the largest of the values recorded in `time`.
/// Infinite without any time.
double unseenRate(double time, double confidence = 0.95);
/// The same model: upper confidence limit of the share of unseen stretches of one unit of `time` with at
/// least one violation, 1 - exp(-unseenRate()) = 1 - (1 - confidence)^(1 / time). 1 without any time.
double unseenTimeShare(double time, double confidence = 0.95);

/// Gumbel distribution of maxima (extreme value distribution of type I): P(x <= q) = exp(-exp(-(q - location)
/// / scale)).
struct GumbelFit {
  double location{0.0}, scale{0.0};
  /// Largest difference of the fitted and the empirical distribution (Kolmogorov-Smirnov); 0: perfect fit.
  double misfit{0.0};
  std::size_t count{0};  ///< of the fitted values

  double quantile(double probability) const;
  double probability(double value) const;
};

/// Fit by probability weighted moments (Landwehr, Matalas and Wallis 1979). Values that are not finite are
/// ignored; nullopt for fewer than 5 values or if all are equal.
std::optional<GumbelFit> fitGumbel(std::span<const double> values);

/// The misfit that 5 % of all samples of `count` values from a true Gumbel distribution exceed, with location
/// and scale fitted by fitGumbel(): approximately, from simulations of 5 to 1,000 values. A larger misfit
/// speaks against the distribution.
double criticalMisfit(std::size_t count);

}  // namespace abstand::margin
