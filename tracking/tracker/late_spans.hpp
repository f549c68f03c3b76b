// Times at which one of two cameras sees people move later than the other.
#pragma once

#include <vector>

#include "tracking/tracker/apart_spans.hpp"

namespace abstand::tracking {

/// From `since` to `until` (s; infinite: until the end), the second camera is `late` (s; negative: early).
struct LateSpan {
  double since{0.0}, until{kInfinity};
  double late{0.0};

  static constexpr double kLate = 0.1;  ///< s, three images
};

/// Compares the movements (estimateClockOffset) in windows of 2.5 s, 0.5 s apart. Two in a row must show the
/// same difference of at least LateSpan::kLate. It ends with a window that shows none; those in which people
/// move too little show nothing. May allocate.
std::vector<LateSpan> lateSpans(std::span<const SeenTwice> seen);

}  // namespace abstand::tracking
