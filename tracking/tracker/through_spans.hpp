// Times at which one camera sees through what another one measures.
#pragma once

#include <span>
#include <vector>

#include "tracking/tracker/apart_spans.hpp"
#include "tracking/tracker/seen_through.hpp"

namespace abstand::tracking {

/// Two cameras at one time, each in the view of the other one.
struct ThroughAt {
  double t{0.0};             ///< s
  double share{kNaN};        ///< SeenThrough::share(); NaN: too few points
  double displacement{0.0};  ///< m

  /// Share that is not noise: calibrated cameras had at most 0.003 in any image, one that was turned by 2
  /// degrees to the side or down, or 0.1 m too high, 0.056 to 0.39 in the median.
  static constexpr double kShare = 0.02;
  static constexpr std::size_t kFewest = 40;  ///< points
};

ThroughAt throughAt(double t, const LabelledImage& a, const LabelledImage& b);

/// Times in order. The median of the share over 0.5 s is above ThroughAt::kShare for 0.5 s or longer; it ends
/// when it is below for as long. Times without people do not count. May allocate.
std::vector<ApartSpan> throughSpans(std::span<const ThroughAt> seen);

}  // namespace abstand::tracking
