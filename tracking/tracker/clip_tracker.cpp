// Passes over a stream: people in each image, and the body of each.
#include "tracking/tracker/clip_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "core/base/error.hpp"
#include "humanmodel/joint_covariance.hpp"
#include "tracking/depth/people/camera_watch.hpp"
#include "tracking/tracker/camera_stand.hpp"
#include "tracking/tracker/people_across.hpp"

namespace abstand::tracking {
namespace {

constexpr double kLearning = 5.0;   // s of the stream used to learn sizes
constexpr double kCompared = 20.0;  // s of two streams used to compare their clocks

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One of the cameras during a pass.
struct PassCamera {
  const DepthCamera* camera;
  PeopleFinder finder;
  CameraWatch watch;
  std::vector<std::uint8_t> mask;
  bool isMoved() const { return std::isfinite(watch.movedAt()); }
};

/// A person of a moment in one camera's image.
struct Sighting {
  int person;  ///< common to all cameras
  std::size_t camera;
  int id;  ///< of the camera's finder
};

Eigen::Vector2d placeOf(const FoundPerson& person, const DepthCamera& camera) {
  const Vector3d p_W = camera.X_WC * person.centroid;
  const Eigen::Vector2d away = (p_W - camera.X_WC.translation()).head<2>();
  return p_W.head<2>() + BodyTracker::kHalfBody * away.normalized();
}

/// Adds to the last frame what each joint moved in `lag` (s) at its present speed.
void widenByLag(double lag, std::vector<humanmodel::SkeletonFrame>& frames) {
  if (lag <= 0.0 || frames.size() < 2) return;
  humanmodel::SkeletonFrame& frame = frames.back();
  const humanmodel::SkeletonFrame& last = frames[frames.size() - 2];
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    if (!frame.has(joint) || !last.has(joint)) continue;
    const double moved = (frame.p[j] - last.p[j]).norm() * lag / (frame.t - last.t);
    humanmodel::addSpread(frame, joint, moved);
  }
}

class ClipPasses {
 public:
  ClipPasses(std::span<const ClipCamera> streams, const ClipTrackerOptions& options)
      : streams_{streams}, options_{options}, moments_{streams} {}

  ClipTrack run() {
    for (const ClipCamera& camera : streams_) cameras_.push_back(camera.stream->camera());
    estimateCameraPose();
    track_.camera = cameras_.front();
    for (const DepthCamera& camera : cameras_)
      track_.camera.spread = std::max(track_.camera.spread, camera.spread);
    std::map<int, KnownBody> learned;
    const double end =
        moments_.size() == 0 ? 0.0 : std::min(moments_.times().front() + kLearning, options_.until);
    pass(end, learned, false);
    pass(options_.until, learned, true);
    finishTrack(track_);
    return std::move(track_);
  }

 private:
  void estimateCameraPose() {
    DepthStream& stream = *streams_.front().stream;
    if (stream.facts().pose_known) {
      track_.world = cameras_.size() == 1 ? "the camera pose is taken from its file"
                                          : "the camera poses are taken from their files";
      return;
    }
    stream.seek(0);
    DepthFrame frame;
    CameraStand camera_pose(cameras_.front());
    while (!isInterrupted() && stream.next(frame) && !camera_pose.see(frame.t, frame.image)) {
    }
    camera_pose.settle();
    cameras_.front().X_WC = camera_pose.X_WC();
    track_.world = camera_pose.reason();
  }

  bool isInterrupted() {
    track_.interrupted = track_.interrupted || (options_.interrupted && options_.interrupted());
    return track_.interrupted;
  }

  /// People in the images of a moment, by increasing number of the person.
  void findPeople(const DepthMoment& moment, std::vector<PassCamera>& cameras, PeopleAcross& across) {
    sightings_.clear();
    places_.clear();
    for (std::size_t c = 0; c < cameras.size(); ++c) {
      if (!moment.frames[c]) continue;
      PassCamera& camera = cameras[c];
      if (camera.isMoved()) continue;
      const DepthFrame& frame = *moment.frames[c];
      if (moment.is_new[c]) {
        const DepthImage* known = options_.known ? options_.known(moment.t, *camera.camera) : nullptr;
        const PeopleImage& people = camera.finder.find(frame.t, frame.image, known);
        camera.watch.see(moment.t, frame.image, people.label, known);
        if (camera.isMoved()) continue;
      }
      for (const FoundPerson& person : camera.finder.people().persons) {
        sightings_.push_back({person.id, c, person.id});
        places_.push_back({c, person.id, placeOf(person, *camera.camera)});
      }
    }
    if (cameras.size() == 1) return;
    const std::span<const int> ids = across.match(moment.t, places_);
    for (std::size_t i = 0; i < ids.size(); ++i) sightings_[i].person = ids[i];
    std::stable_sort(sightings_.begin(), sightings_.end(),
                     [](const Sighting& a, const Sighting& b) { return a.person < b.person; });
  }

  void noteCameras(const DepthMoment& moment, const std::vector<PassCamera>& cameras) {
    track_.cameras.resize(cameras.size());
    for (std::size_t c = 0; c < cameras.size(); ++c) {
      CameraShare& share = track_.cameras[c];
      share.repeated = cameras[c].watch.repeated();
      if (cameras[c].isMoved() && !std::isfinite(share.moved_at)) {
        share.moved_at = cameras[c].watch.movedAt();
        loseSince(share.moved_at);
      }
      share.without += moment.frames[c] == nullptr || cameras[c].isMoved();
      if (!moment.is_new[c] || cameras[c].isMoved()) continue;
      ++share.images;
      share.people += !cameras[c].finder.people().persons.empty();
    }
    if (!sightings_.empty()) track_.lag = std::max(track_.lag, moment.lag);
  }

  /// The frames since `t` were fitted to images of a camera that had been moved.
  void loseSince(double t) {
    for (ClipPerson& person : track_.people)
      for (humanmodel::SkeletonFrame& frame : person.frames) {
        if (frame.t < t) continue;
        person.found -= frame.has(humanmodel::Joint::kPelvis) ? 1 : 0;
        humanmodel::SkeletonFrame none;
        none.t = frame.t;
        frame = none;
      }
  }

  TrackedPerson& trackerOf(int person, const std::map<int, KnownBody>& learned,
                           std::map<int, TrackedPerson>& trackers) const {
    if (const auto it = trackers.find(person); it != trackers.end()) return it->second;
    const auto of = learned.find(person);
    return of != learned.end() ? trackers.try_emplace(person, options_.person, of->second).first->second
                               : trackers.try_emplace(person, options_.person).first->second;
  }

  /// Processes all moments before `end`; learns sizes, or tracks with the learned ones.
  void pass(double end, std::map<int, KnownBody>& learned, bool keep) {
    moments_.rewind();
    std::vector<PassCamera> cameras;
    for (const DepthCamera& camera : cameras_)
      cameras.push_back({&camera, PeopleFinder(camera), CameraWatch(camera), {}});
    PeopleAcross across;
    std::map<int, TrackedPerson> trackers;
    std::map<int, std::size_t> place;  // index in track_.people of each person
    DepthMoment moment;
    std::vector<PersonImage> images;
    for (std::size_t i = 0; moments_.next(moment) && moment.t < end; ++i) {
      if (isInterrupted()) break;
      const double begin = processorSeconds();
      findPeople(moment, cameras, across);
      if (keep) noteCameras(moment, cameras);
      for (std::size_t k = 0; k < sightings_.size();) {
        const int person = sightings_[k].person;
        const std::size_t first = sightings_[k].camera;
        images.clear();
        for (; k < sightings_.size() && sightings_[k].person == person; ++k) {
          PassCamera& camera = cameras[sightings_[k].camera];
          camera.finder.mask(sightings_[k].id, camera.mask);
          images.push_back({&moment.frames[sightings_[k].camera]->image, camera.camera, camera.mask});
        }
        TrackedPerson& tracker = trackerOf(person, learned, trackers);
        const TrackedBody* body = tracker.see(moment.t, images);
        if (!keep) continue;
        noteMoment(track_, place, person, moment.t, body, true);
        if (body && body->found) noteHeld(track_.people[place[person]], tracker.held().extent());
        widenByLag(images.size() > 1 ? moment.lag : 0.0, track_.people[place[person]].frames);
        if (!body || !options_.watch) continue;
        const double pause = processorSeconds();
        options_.watch({i, person, *moment.frames[first], *cameras[first].camera, tracker.rig(), *body});
        track_.seconds -= processorSeconds() - pause;
      }
      if (!keep) continue;
      noteAbsent(moment.t, place);
      track_.seconds += processorSeconds() - begin;
      ++track_.images;
      if (options_.progress) options_.progress(i + 1, moments_.size());
    }
    learn(trackers, place, keep, learned);
  }

  /// People not in these images are lost.
  void noteAbsent(double t, const std::map<int, std::size_t>& place) {
    humanmodel::SkeletonFrame none;
    none.t = t;
    for (const auto& [id, k] : place)
      if (track_.people[k].frames.back().t < t) track_.people[k].frames.push_back(none);
  }

  void learn(std::map<int, TrackedPerson>& trackers, const std::map<int, std::size_t>& place, bool keep,
             std::map<int, KnownBody>& learned) {
    for (auto& [id, person] : trackers) {
      if (!keep) {
        person.settle();
        person.settle();
      }
      if (!person.body()) continue;
      learned.insert_or_assign(id, KnownBody{*person.body(), person.stature(), person.facing(),
                                             person.things(), person.held().atStart()});
      if (!keep || place.count(id) == 0) continue;
      ClipPerson& tracked = track_.people[place.at(id)];
      tracked.body = *person.body();
      tracked.facing = person.facing();
      tracked.stature = person.stature();
    }
  }

  std::span<const ClipCamera> streams_;
  const ClipTrackerOptions& options_;
  DepthMoments moments_;
  std::vector<DepthCamera> cameras_;
  std::vector<Sighting> sightings_;
  std::vector<SeenPlace> places_;
  ClipTrack track_;
};

}  // namespace

void noteMoment(ClipTrack& track, std::map<int, std::size_t>& place, int id, double t,
                const TrackedBody* body, bool keep) {
  const auto [it, is_new] = place.try_emplace(id, track.people.size());
  if (is_new) {
    track.people.emplace_back();
    track.people.back().id = id;
    track.people.back().residual = 0.0;
  }
  ClipPerson& person = track.people[it->second];
  if (keep) {
    humanmodel::SkeletonFrame none;
    none.t = t;
    person.frames.push_back(body ? body->frame : none);
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      humanmodel::addSpread(person.frames.back(), static_cast<humanmodel::Joint>(j), track.camera.spread);
  }
  if (!body || !body->found) return;
  ++person.found;
  person.residual += body->misfit.residual;
}

void noteHeld(ClipPerson& person, const HeldThings::Extents& extent) {
  for (std::size_t k = 0; k < extent.size(); ++k) {
    person.held[k] += extent[k] > 0.0;
    person.held_extent[k] = std::max(person.held_extent[k], extent[k]);
  }
}

void finishTrack(ClipTrack& track) {
  for (ClipPerson& person : track.people)
    person.residual /= std::max<double>(1.0, static_cast<double>(person.found));
  std::stable_sort(track.people.begin(), track.people.end(),
                   [](const ClipPerson& a, const ClipPerson& b) { return a.found > b.found; });
}

ClipTrack trackClip(DepthStream& stream, const ClipTrackerOptions& options) {
  const ClipCamera camera{&stream, 0.0};
  return ClipPasses({&camera, 1}, options).run();
}

ClipTrack trackClips(std::span<const ClipCamera> cameras, const ClipTrackerOptions& options) {
  if (cameras.empty() || cameras.size() > BodyObservation::kMaxViews)
    throw UsageError("found " + std::to_string(cameras.size()) + " depth cameras, expected 1 to " +
                     std::to_string(BodyObservation::kMaxViews));
  for (const ClipCamera& camera : cameras)
    if (cameras.size() > 1 && !camera.stream->facts().pose_known)
      throw UsageError(
          "found several depth cameras, one without a pose, expected T_WC in a camera "
          "file for each");
  return ClipPasses(cameras, options).run();
}

ClockOffset clockOffset(DepthStream& first, DepthStream& second, const ClipTrackerOptions& options) {
  ClipTrackerOptions alone = options;
  alone.watch = {};
  alone.progress = {};
  const auto tracked = [&](DepthStream& stream) {
    alone.until = stream.times().empty() ? 0.0 : stream.times().front() + kCompared;
    return trackClip(stream, alone);
  };
  const ClipTrack a = tracked(first), b = tracked(second);
  ClockOffset best;
  best.apart = kInfinity;
  for (const ClipPerson& one : a.people) {
    for (const ClipPerson& other : b.people) {
      const ClockOffset offset = estimateClockOffset(one.frames, other.frames);
      const bool is_better = offset.decided != best.decided ? offset.decided : offset.apart < best.apart;
      if (offset.overlap > 0.0 && is_better) best = offset;
    }
  }
  return best;
}

}  // namespace abstand::tracking
