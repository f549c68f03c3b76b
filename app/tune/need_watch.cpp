#include "app/tune/need_watch.hpp"

namespace abstand::tune {

void NeedWatch::add(double t, const NearestPair& nearest, double between, double braking) {
  const bool was_decided = need_.decided;
  watch_.add(nearest.clearance, between, braking);
  const margin::SafeMargin& safe = watch_.value();
  if (safe.decided && (!was_decided || safe.margin != need_.margin)) {
    // A contact before the next frame is decided by this frame's clearance, a late stop by the previous one.
    const NearestPair& told = safe.margin == nearest.clearance ? nearest : before_;
    need_ = {safe.margin, true, t, told.clearance, told.bound, told.uncertainty, safe.sampling};
  }
  before_ = nearest;
}

}  // namespace abstand::tune
