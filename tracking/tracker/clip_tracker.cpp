// Passes over a stream: people in each image, and the body of each.
#include "tracking/tracker/clip_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "humanmodel/joint_covariance.hpp"
#include "tracking/tracker/camera_stand.hpp"
#include "tracking/tracker/earlier_images.hpp"

namespace abstand::tracking {
namespace {

constexpr double kLearning = 5.0;   // s of the stream used to learn sizes
constexpr double kCompared = 20.0;  // s of two streams used to compare their clocks

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

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
    CameraStand camera_pose(cameras_.front(), options_.person.height);
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
    PeopleViews views(cameras_);
    views.expect(arrivals_);
    std::map<int, TrackedPerson> trackers;
    std::map<int, std::size_t> place;  // index in track_.people of each person
    DepthMoment moment;
    for (std::size_t i = 0; moments_.next(moment) && moment.t < end; ++i) {
      if (isInterrupted()) break;
      const double begin = processorSeconds();
      views.see(moment, options_.known);
      if (keep) loseSince(track_, views.note(track_.cameras));
      earlier_.keep(i, moment, views);
      views.each([&](int person, std::size_t first, std::span<const PersonImage> images) {
        TrackedPerson& tracker = trackerOf(person, learned, trackers);
        const TrackedBody* body = tracker.see(moment.t, images);
        if (!keep) return;
        if (!body) return noteMoment(track_, place, person, moment.t, nullptr, true);
        if (body->found && place.count(person) == 0)
          for (const EarlierImages::Tracked& before : earlier_.track(i, person, views, tracker))
            record({before.number, person, before.frame, *before.camera, tracker.rig(), before.body},
                   before.lag, tracker, place);
        record({i, person, *moment.frames[first], cameras_[first], tracker.rig(), *body},
               images.size() > 1 ? moment.lag : 0.0, tracker, place);
      });
      if (!keep) continue;
      noteAbsent(moment.t, place);
      track_.seconds += processorSeconds() - begin;
      ++track_.images;
      if (options_.progress) options_.progress(i + 1, moments_.size());
    }
    learn(trackers, place, keep, learned);
    arrivals_ = views.arrivals();
  }

  /// Into track_, and to whom it may concern. `lag` (s): of images that were fitted together.
  void record(const ClipMoment& moment, double lag, const TrackedPerson& tracker,
              std::map<int, std::size_t>& place) {
    noteMoment(track_, place, moment.id, moment.body.frame.t, &moment.body, true);
    ClipPerson& person = track_.people[place[moment.id]];
    if (moment.body.found) noteHeld(person, tracker.held().extent());
    track_.lag = std::max(track_.lag, lag);
    if (person.frames.size() > 1)
      widenByLag(lag, person.frames[person.frames.size() - 2], person.frames.back());
    if (!options_.watch) return;
    const double pause = processorSeconds();
    options_.watch(moment);
    track_.seconds -= processorSeconds() - pause;
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
  std::vector<std::vector<Arrival>> arrivals_;  // in the last pass, for each camera
  EarlierImages earlier_;
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

void loseSince(ClipTrack& track, double t) {
  if (t == kInfinity) return;
  for (ClipPerson& person : track.people)
    for (humanmodel::SkeletonFrame& frame : person.frames) {
      if (frame.t < t) continue;
      person.found -= frame.has(humanmodel::Joint::kPelvis) ? 1 : 0;
      humanmodel::SkeletonFrame none;
      none.t = frame.t;
      frame = none;
    }
}

void widenByLag(double lag, const humanmodel::SkeletonFrame& before, humanmodel::SkeletonFrame& frame) {
  if (lag <= 0.0) return;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    if (!frame.has(joint) || !before.has(joint)) continue;
    const double moved = (frame.p[j] - before.p[j]).norm() * lag / (frame.t - before.t);
    humanmodel::addSpread(frame, joint, moved);
  }
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
  requireCameras(cameras.size(), std::all_of(cameras.begin(), cameras.end(), [](const ClipCamera& camera) {
                   return camera.stream->facts().pose_known;
                 }));
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
