// How long something was how near.
#pragma once

#include <algorithm>
#include <array>

#include "core/math/transform.hpp"

namespace abstand::margin {

/// m: certified clearances below which time is counted. Below 0 contact is not excluded.
inline constexpr std::array<double, 5> kExposureBands{0.0, 0.05, 0.1, 0.2, 0.5};

/// Whether a clearance says something about the bands. One that is below the largest band says nothing where
/// the body was not seen, or where what is not known of the poses (m) is as large as that band: it may as
/// well be outside of all bands.
inline bool isExposureKnown(double clearance, double uncertainty) {
  if (clearance >= kExposureBands.back()) return true;
  return clearance > -kInfinity && uncertainty < kExposureBands.back();
}

/// Exposure (docs/margins.md, "Exposure"). Sums over stretches of time, so exposures of recordings add up.
struct ExposureTime {
  /// s, with a certified clearance below kExposureBands.
  std::array<double, kExposureBands.size()> below{};
  /// s, the sum of duration times (1 - clearance / largest band), a factor of 0 at the largest band and
  /// beyond, and of 1 below 0. The same is the time below a band, averaged over all bands from 0 to the
  /// largest.
  double weighted{0.0};

  /// A stretch of `duration` (s) with a clearance (m); infinite: far away.
  void add(double clearance, double duration) {
    if (!(clearance < kExposureBands.back())) return;
    for (std::size_t b = 0; b < below.size(); ++b)
      if (clearance < kExposureBands[b]) below[b] += duration;
    weighted += duration * std::min(1.0, 1.0 - clearance / kExposureBands.back());
  }
  void add(const ExposureTime& other) {
    for (std::size_t b = 0; b < below.size(); ++b) below[b] += other.below[b];
    weighted += other.weighted;
  }
};

}  // namespace abstand::margin
