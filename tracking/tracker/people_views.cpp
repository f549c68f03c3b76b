#include "tracking/tracker/people_views.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/tracker/body_tracker.hpp"

namespace abstand::tracking {
namespace {

Eigen::Vector2d placeOf(const FoundPerson& person, const DepthCamera& camera) {
  const Vector3d p_W = camera.X_WC * person.centroid;
  const Eigen::Vector2d away = (p_W - camera.X_WC.translation()).head<2>();
  return p_W.head<2>() + BodyTracker::kHalfBody * away.normalized();
}

}  // namespace

void requireCameras(std::size_t count, bool poses_known) {
  if (count == 0 || count > BodyObservation::kMaxViews)
    throw UsageError("found " + std::to_string(count) + " depth cameras, expected 1 to " +
                     std::to_string(BodyObservation::kMaxViews));
  if (count > 1 && !poses_known)
    throw UsageError(
        "found several depth cameras, one without a pose, expected T_WC in a camera file for each");
}

PeopleViews::PeopleViews(std::span<const DepthCamera> cameras, double hung_after) : hung_after_(hung_after) {
  views_.reserve(cameras.size());
  for (const DepthCamera& camera : cameras)
    views_.push_back({&camera, PeopleFinder(camera), CameraWatch(camera), {}, false});
}

void PeopleViews::expect(const std::vector<SeenBefore>& seen) {
  for (std::size_t c = 0; c < seen.size(); ++c) views_[c].finder.expect(seen[c]);
}

std::vector<SeenBefore> PeopleViews::seen() const {
  std::vector<SeenBefore> seen;
  for (const View& view : views_) seen.push_back(view.finder.seen());
  return seen;
}

std::vector<std::vector<Arrival>> PeopleViews::arrivals() const {
  std::vector<std::vector<Arrival>> arrivals;
  for (const View& view : views_) arrivals.push_back(view.finder.arrivals());
  return arrivals;
}

void PeopleViews::see(const DepthMoment& moment, const KnownThings& known) {
  moment_ = &moment;
  sightings_.clear();
  foreseen_.clear();
  places_.clear();
  for (std::size_t c = 0; c < views_.size(); ++c) {
    View& view = views_[c];
    if (!moment.frames[c] || isMoved(c) || view.is_out) continue;
    const DepthFrame& frame = *moment.frames[c];
    if (moment.is_new[c]) {
      const DepthImage* things = known ? known(moment.t, *view.camera) : nullptr;
      const PeopleImage& people = view.finder.find(frame.t, frame.image, things);
      view.watch.see(moment.t, frame.image, people.label, things);
      if (isMoved(c)) continue;
    }
    if (isHung(c)) continue;
    for (const FoundPerson& person : view.finder.people().persons) {
      (person.foreseen ? foreseen_ : sightings_).push_back({person.id, c, person.id});
      if (person.foreseen) continue;
      places_.push_back({c, person.id, placeOf(person, *view.camera)});
    }
  }
  if (views_.size() == 1) return;
  const std::span<const int> ids = across_.match(moment.t, places_);
  for (std::size_t i = 0; i < ids.size(); ++i) sightings_[i].person = ids[i];
  std::stable_sort(sightings_.begin(), sightings_.end(),
                   [](const Sighting& a, const Sighting& b) { return a.person < b.person; });
}

bool PeopleViews::isHung(std::size_t camera) const {
  return moment_->t - views_[camera].watch.unchangedSince() >= hung_after_;
}

int PeopleViews::idOf(int person, std::size_t camera) const {
  const auto is_it = [&](const Sighting& s) { return s.person == person && s.camera == camera; };
  const auto it = std::find_if(sightings_.begin(), sightings_.end(), is_it);
  return it == sightings_.end() ? -1 : it->id;
}

PersonImage PeopleViews::imageOf(const Sighting& sighting) {
  View& view = views_[sighting.camera];
  view.finder.mask(sighting.id, view.mask);
  return {&moment_->frames[sighting.camera]->image, view.camera, view.mask, sighting.camera};
}

double PeopleViews::note(std::vector<CameraShare>& shares) const {
  double moved = kInfinity;
  shares.resize(views_.size());
  for (std::size_t c = 0; c < views_.size(); ++c) {
    CameraShare& share = shares[c];
    share.repeated = views_[c].watch.repeated();
    if (isMoved(c) && !std::isfinite(share.moved_at)) {
      share.moved_at = views_[c].watch.movedAt();
      moved = std::min(moved, share.moved_at);
    }
    const double unchanged = unchangedSince(c);
    if (moment_->t - unchanged >= CameraShare::kHung) share.hung_at = std::min(share.hung_at, unchanged);
    const bool is_used = moment_->frames[c] != nullptr && !isMoved(c) && !isHung(c) && !views_[c].is_out;
    share.without += !is_used;
    if (!moment_->is_new[c] || !is_used) continue;
    ++share.images;
    share.people += !views_[c].finder.people().persons.empty();
  }
  return moved;
}

}  // namespace abstand::tracking
