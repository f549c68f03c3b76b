// Exposure: time spent below clearance bands.
#pragma once

#include <algorithm>
#include <array>

#include "core/math/transform.hpp"

namespace abstand::margin {

/// m: bands, upper limits of the certified clearance whose time is counted. Below 0 contact is not excluded.
inline constexpr std::array<double, 5> kExposureBands{0.0, 0.05, 0.1, 0.2, 0.5};

/// True if a clearance says something about the bands. False for a clearance below the largest band if the
/// body was not seen, or if the pose uncertainty (m) is at least that band: it may then as well be outside of
/// all bands.
inline bool isExposureKnown(double clearance, double uncertainty) {
  if (clearance >= kExposureBands.back()) return true;
  return clearance > -kInfinity && uncertainty < kExposureBands.back();
}

/// Exposure (docs/margins.md, "Exposure"). Sums over time intervals, so exposures of recordings can be added.
struct ExposureTime {
  /// s, with a certified clearance below each of kExposureBands.
  std::array<double, kExposureBands.size()> below{};
  /// s, integral of (1 - clearance / largest band) over time, clamped to 0 at the largest band and 1 below 0.
  /// Equal to the time below a band, averaged over all bands from 0 to the largest.
  double weighted{0.0};

  /// Adds an interval of `duration` (s) with a clearance (m); infinite: far away.
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
