#include "tracking/tracker/shown_things.hpp"

namespace abstand::tracking {

bool ShownThings::see(double t, const DepthImage& image, const DepthImage* known, const DepthImage* at_rest,
                      const DepthCamera& camera) {
  if (!known || !isDue(t)) return shown_;
  next_ = t + kEvery;
  KnownPixels pixels;
  pixels.add(image, *known);
  there_ = kForget * there_ + static_cast<double>(pixels.there);
  all_ = kForget * all_ + static_cast<double>(pixels.there + pixels.through);
  const bool is_measured = at_rest && displaced_.add(image, *at_rest, camera, kForget);
  if (all_ >= kPixels)
    shown_ = share() >= (shown_ || (is_measured && displaced_.areNear()) ? kElsewhere : kThere);
  return shown_;
}

double ShownThings::share() const { return all_ > 0.0 ? there_ / all_ : kNaN; }

}  // namespace abstand::tracking
