#include "tracking/tracker/fitted_clip.hpp"

#include <algorithm>

namespace abstand::tracking {

std::size_t FittedClip::imageAt(double t) const {
  const auto after = std::upper_bound(times.begin(), times.end(), t);
  return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}

void FitLog::note(const ClipMoment& moment) {
  if (moment.body.found) fits_[moment.id][moment.image] = {moment.body.pose, moment.rig};
}

FittedClip FitLog::clipOf(const ClipTrack& track, std::size_t person, const DepthStream& stream) {
  const ClipPerson& tracked = track.people.at(person);
  FittedClip clip;
  clip.camera = track.camera;
  clip.camera_reason = stream.facts().camera_reason;
  clip.world = track.world;
  clip.times = stream.times();
  clip.images.resize(clip.times.size());
  if (!tracked.frames.empty()) clip.first_t = tracked.frames.front().t;
  const std::map<std::size_t, Fit>& fits = fits_[tracked.id];
  for (const humanmodel::SkeletonFrame& frame : tracked.frames) {
    const std::size_t i = clip.imageAt(frame.t);
    FittedImage& image = clip.images[i];
    image.joints = frame;
    const auto fit = fits.find(i);
    if (fit == fits.end() || !frame.has(humanmodel::Joint::kPelvis)) continue;
    image.found = true;
    image.pose = fit->second.pose;
    image.rig = fit->second.rig;
  }
  return clip;
}

}  // namespace abstand::tracking
