// Tracks people in live depth images.
#include "tracking/tracker/live_tracker.hpp"

#include <algorithm>

#include "humanmodel/joint_covariance.hpp"
#include "tracking/tracker/doubtful_cameras.hpp"

namespace abstand::tracking {
namespace {

// s; longer than the finder keeps an id, so that no person returns to a body that is deleted.
constexpr double kForgotten = 10.0;

}  // namespace

LiveTracker::LiveTracker(std::span<const DepthCamera> cameras, bool poses_known,
                         const LiveTrackerOptions& options)
    : options_(options),
      cameras_(cameras.begin(), cameras.end()),
      shown_(cameras.size()),
      banded_(cameras.size()) {
  requireCameras(cameras.size(), poses_known);
  track_.camera = cameras_.front();
  for (const DepthCamera& camera : cameras_)
    track_.camera.spread = std::max(track_.camera.spread, camera.spread);
  seen_.reserve(PeopleFinder::kMaxPeople);
  if (poses_known) {
    track_.world = cameras.size() == 1 ? "the camera pose is taken from its file"
                                       : "the camera poses are taken from their files";
    views_.emplace(cameras_, CameraShare::kHung);
    if (cameras.size() > 1)
      agreement_ = std::make_unique<LiveAgreement>(cameras_, options_.person, options_.person.fit_aside);
  } else {
    track_.world = "undetermined: no image";
    stand_.emplace(cameras_.front(), options_.person.height);
  }
}

bool LiveTracker::decideWorld(const DepthMoment& moment) {
  if (!stand_) return true;
  if (!stand_->see(moment.t, moment.frames.front()->image)) return false;
  cameras_.front().X_WC = track_.camera.X_WC = stand_->X_WC();
  track_.world = stand_->reason();
  views_.emplace(cameras_, CameraShare::kHung);
  stand_.reset();
  return true;
}

/// Of a camera of this tracker.
const DepthImage* LiveTracker::knownFor(const DepthMoment& moment, const DepthCamera& camera) {
  const auto c = static_cast<std::size_t>(&camera - cameras_.data());
  const DepthImage* known = options_.known(moment.t, camera);
  const bool is_measured = options_.at_rest && shown_[c].isDue(moment.t);
  const DepthImage* at_rest = is_measured ? options_.at_rest(moment.t, camera) : nullptr;
  if (!shown_[c].see(moment.t, moment.frames[c]->image, known, at_rest, camera) || !known) return nullptr;
  return known_now_[c] = &banded_[c].around(*known, camera, shown_[c].displaced().band());
}

/// What the cameras show of each other. Who was found with a camera that was wrong, is lost.
void LiveTracker::judgeCameras(double t) {
  const std::span<const CameraFault> now = agreement_->faults();
  for (const CameraFault& fault : now) {
    const bool is_new = std::none_of(faults_.begin(), faults_.end(), [&](const CameraFault& old) {
      return old.camera == fault.camera && old.kind == fault.kind && old.since == fault.since;
    });
    if (is_new && fault.leavesOut()) loseSince(track_, fault.since);
  }
  faults_.assign(now.begin(), now.end());
  for (std::size_t c = 0; c < cameras_.size(); ++c) views_->leaveOut(c, !isUsable(faults_, c, t));
}

std::span<const LiveTracker::Seen> LiveTracker::see(const DepthFrame& frame) {
  return see({.t = frame.t, .frames = {&frame}, .is_new = {true}});
}

std::span<const LiveTracker::Seen> LiveTracker::see(const DepthMoment& moment) {
  seen_.clear();
  ++track_.images;
  if (!decideWorld(moment)) return seen_;
  if (agreement_) judgeCameras(moment.t);
  known_now_.assign(cameras_.size(), nullptr);
  if (options_.known)
    views_->see(moment, [&](double, const DepthCamera& camera) { return knownFor(moment, camera); });
  else
    views_->see(moment, {});
  loseSince(track_, views_->note(track_.cameras));
  if (agreement_) {
    agreement_->offer(moment, known_now_);
    stateFaults(faults_, 0.0, track_.cameras);
  }
  if (!views_->empty()) track_.lag = std::max(track_.lag, moment.lag);
  views_->each([&](int id, std::size_t first, std::span<const PersonImage> images) {
    follow(moment, id, first, images);
  });
  forget(moment.t);
  return seen_;
}

void LiveTracker::follow(const DepthMoment& moment, int id, std::size_t first,
                         std::span<const PersonImage> images) {
  Follower& follower = followers_.try_emplace(id, options_.person).first->second;
  follower.last = moment.t;
  TrackedPerson& tracker = follower.person;
  const TrackedBody* body = tracker.see(moment.t, images);
  noteMoment(track_, place_, id, moment.t, body, options_.keep);
  if (!body) return;
  if (body->found) {
    ClipPerson& person = track_.people[place_.at(id)];
    noteHeld(person, tracker.held().extent());
    Seen& seen = seen_.emplace_back(Seen{id, body, body->frame});
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      humanmodel::addSpread(seen.frame, static_cast<humanmodel::Joint>(j), track_.camera.spread);
    if (images.size() > 1) widenByLag(moment.lag + lateAt(faults_, moment.t), follower.before, seen.frame);
    const double doubt = doubtAt(faults_, moment.t);
    for (std::size_t j = 0; doubt > 0.0 && j < humanmodel::kJointCount; ++j)
      if (seen.frame.has(static_cast<humanmodel::Joint>(j)))
        humanmodel::addRadius(seen.frame, static_cast<humanmodel::Joint>(j), doubt);
    follower.before = seen.frame;
    if (options_.keep) person.frames.back() = seen.frame;
  }
  if (options_.watch)
    options_.watch({track_.images - 1, id, *moment.frames[first], cameras_[first], tracker.rig(), *body});
}

/// People not in this image are lost; after a while their bodies are deleted.
void LiveTracker::forget(double t) {
  humanmodel::SkeletonFrame none;
  none.t = t;
  for (auto it = followers_.begin(); it != followers_.end();) {
    const auto& [id, follower] = *it;
    ClipPerson& person = track_.people[place_.at(id)];
    if (follower.person.hasBody()) {
      person.body = follower.person.body();
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
