#include "tracking/tracker/facing_trial.hpp"

#include <algorithm>

namespace abstand::tracking {

void FacingTrial::add(double camera, double away) {
  ++images_;
  camera_ += camera;
  away_ += away;
}

double FacingTrial::ratio() const { return images_ == 0 ? kNaN : away_ / camera_; }

void FacingTrial::judge(Facing& facing) const {
  const double now = ratio();
  const bool is_clear = std::max(now, 1.0 / now) > kClear;
  if (images_ >= kMinImages || (images_ >= kFewImages && is_clear)) facing.ratio = now;
}

}  // namespace abstand::tracking
