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

/// Gumbel distribution of maxima (extreme value distribution of type I): P(x <= q) = exp(-exp(-(q - location)
/// / scale)).
struct GumbelFit {
  double location{0.0}, scale{0.0};
  /// Largest difference of the fitted and the empirical distribution (Kolmogorov-Smirnov); 0: perfect fit.
  double misfit{0.0};

  double quantile(double probability) const;
  double probability(double value) const;
};

/// Fit by probability weighted moments (Landwehr, Matalas and Wallis 1979). Values that are not finite are
/// ignored; nullopt for fewer than 5 values or if all are equal.
std::optional<GumbelFit> fitGumbel(std::span<const double> values);

}  // namespace abstand::margin
