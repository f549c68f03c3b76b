// How sure one can be of a margin that was read off recordings.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace abstand::margin {

/// The largest share of unseen recordings that may break a margin which none of `count` recordings broke,
/// with probability `confidence`: 1 - (1 - confidence)^(1 / count), about 3 / count at 95 % ("rule of three",
/// Hanley and Lippman-Hand 1983). It holds for the largest of the recordings' own values as well (order
/// statistics, Wilks 1941). Model: seen and unseen recordings are independent and of one kind. 1 for no
/// recording.
double unseenShare(std::size_t count, double confidence = 0.95);

/// Gumbel's distribution of the largest value of many (extreme value distribution of type I):
/// P(x <= q) = exp(-exp(-(q - location) / scale)).
struct GumbelFit {
  double location{0.0}, scale{0.0};
  /// Largest difference of the fitted and the empirical distribution (Kolmogorov and Smirnov): 0 fits best.
  double misfit{0.0};

  double quantile(double probability) const;
  double probability(double value) const;
};

/// By probability weighted moments (Landwehr, Matalas and Wallis 1979). Values that are not finite are left
/// out; nothing below 5 values or where all are equal.
std::optional<GumbelFit> fitGumbel(std::span<const double> values);

}  // namespace abstand::margin
