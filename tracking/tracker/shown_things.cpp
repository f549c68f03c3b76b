#include "tracking/tracker/shown_things.hpp"

namespace abstand::tracking {

bool ShownThings::see(double t, const DepthImage& image, const DepthImage* known, const DepthCamera& camera) {
  if (!known || t < next_) return shown_;
  next_ = t + kEvery;
  KnownPixels pixels;
  pixels.add(image, *known);
  there_ = kForget * there_ + static_cast<double>(pixels.there);
  all_ = kForget * all_ + static_cast<double>(pixels.there + pixels.through);
  displaced_.forget(kForget);
  displaced_.add(image, *known, camera);
  if (all_ >= kPixels) shown_ = share() >= (shown_ ? kElsewhere : kThere) || displaced_.areNear();
  return shown_;
}

double ShownThings::share() const { return all_ > 0.0 ? there_ / all_ : kNaN; }

}  // namespace abstand::tracking
