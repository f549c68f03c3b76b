#include "tracking/recording/recording.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::tracking {

const humanmodel::SkeletonFrame& Recording::at(double t) const {
  ABSTAND_CHECK(!frames.empty());
  auto after = std::upper_bound(frames.begin(), frames.end(), t,
                                [](double value, const humanmodel::SkeletonFrame& f) { return value < f.t; });
  return after == frames.begin() ? *after : *(after - 1);
}

}  // namespace abstand::tracking
