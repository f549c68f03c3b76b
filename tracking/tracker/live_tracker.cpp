// Tracks people in live depth images.
#include "tracking/tracker/live_tracker.hpp"

namespace abstand::tracking {
namespace {

// s; longer than the finder keeps an id, so that no person returns to a body that is deleted.
constexpr double kForgotten = 10.0;

}  // namespace

LiveTracker::LiveTracker(const DepthCamera& camera, bool pose_known, const LiveTrackerOptions& options)
    : options_(options) {
  track_.camera = camera;
  seen_.reserve(PeopleFinder::kMaxPeople);
  if (pose_known) {
    track_.world = "the camera pose is taken from its file";
    finder_.emplace(camera);
  } else {
    track_.world = "undetermined: no image";
    stand_.emplace(camera);
  }
}

std::span<const LiveTracker::Seen> LiveTracker::see(const DepthFrame& frame) {
  seen_.clear();
  ++track_.images;
  if (stand_) {
    if (!stand_->see(frame.t, frame.image)) return seen_;
    track_.camera.X_WC = stand_->X_WC();
    track_.world = stand_->reason();
    finder_.emplace(track_.camera);
    stand_.reset();
  }
  const PeopleImage& people = finder_->find(frame.t, frame.image);
  for (const FoundPerson& person : people.persons) {
    Follower& follower = followers_.try_emplace(person.id, options_.person).first->second;
    follower.last = frame.t;
    TrackedPerson& tracker = follower.person;
    finder_->mask(person.id, mask_);
    const PersonImage image{&frame.image, &track_.camera, mask_};
    const TrackedBody* body = tracker.see(frame.t, {&image, 1});
    noteMoment(track_, place_, person.id, frame.t, body, options_.keep);
    if (body && body->found) noteHeld(track_.people[place_.at(person.id)], tracker.held().extent());
    if (!body) continue;
    if (body->found) seen_.push_back({person.id, body});
    if (options_.watch)
      options_.watch({track_.images - 1, person.id, frame, track_.camera, tracker.rig(), *body});
  }
  forget(frame.t);
  return seen_;
}

/// People not in this image are lost; after a while their bodies are deleted.
void LiveTracker::forget(double t) {
  humanmodel::SkeletonFrame none;
  none.t = t;
  for (auto it = followers_.begin(); it != followers_.end();) {
    const auto& [id, follower] = *it;
    ClipPerson& person = track_.people[place_.at(id)];
    if (follower.person.body()) {
      person.body = *follower.person.body();
      person.facing = follower.person.facing();
      person.stature = follower.person.stature();
    }
    if (options_.keep && follower.last < t) person.frames.push_back(none);
    it = follower.last + kForgotten < t ? followers_.erase(it) : std::next(it);
  }
}

ClipTrack LiveTracker::track() const {
  ClipTrack track = track_;
  finishTrack(track);
  return track;
}

}  // namespace abstand::tracking
