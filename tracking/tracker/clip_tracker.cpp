// Passes over a stream: people in each image, and the body of each.
#include "tracking/tracker/clip_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "tracking/tracker/camera_stand.hpp"

namespace abstand::tracking {
namespace {

constexpr double kLearning = 5.0;  // s of the stream used to learn sizes

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class ClipPasses {
 public:
  ClipPasses(DepthStream& stream, const ClipTrackerOptions& options) : stream_{stream}, options_{options} {}

  ClipTrack run() {
    track_.camera = stream_.camera();
    estimateCameraPose();
    std::map<int, KnownBody> learned;
    const std::vector<double>& times = stream_.times();
    const double end = times.empty() ? 0.0 : times.front() + kLearning;
    pass(end, learned, false);
    pass(kInfinity, learned, true);
    finishTrack(track_);
    return std::move(track_);
  }

 private:
  void estimateCameraPose() {
    if (stream_.facts().pose_known) {
      track_.world = "the camera's pose is that of its file";
      return;
    }
    stream_.seek(0);
    DepthFrame frame;
    CameraStand camera_pose(track_.camera);
    while (!isInterrupted() && stream_.next(frame) && !camera_pose.see(frame.t, frame.image)) {
    }
    camera_pose.settle();
    track_.camera.X_WC = camera_pose.X_WC();
    track_.world = camera_pose.reason();
  }

  bool isInterrupted() {
    track_.interrupted = track_.interrupted || (options_.interrupted && options_.interrupted());
    return track_.interrupted;
  }

  /// Processes all images before `end`; learns sizes, or tracks with the learned ones.
  void pass(double end, std::map<int, KnownBody>& learned, bool keep) {
    stream_.seek(0);
    PeopleFinder finder(track_.camera);
    std::map<int, TrackedPerson> trackers;
    std::map<int, std::size_t> place;  // index in track_.people of each person
    DepthFrame frame;
    std::vector<std::uint8_t> mask;
    for (std::size_t i = 0; stream_.next(frame) && frame.t < end; ++i) {
      if (isInterrupted()) break;
      const DepthImage* known = options_.known ? options_.known(frame.t, track_.camera) : nullptr;
      const double begin = processorSeconds();
      const PeopleImage& people = finder.find(frame.t, frame.image, known);
      for (const FoundPerson& person : people.persons) {
        auto it = trackers.find(person.id);
        if (it == trackers.end()) {
          const auto of = learned.find(person.id);
          it = of != learned.end() ? trackers.try_emplace(person.id, options_.person, of->second).first
                                   : trackers.try_emplace(person.id, options_.person).first;
        }
        finder.mask(person.id, mask);
        const TrackedBody* body = it->second.see(frame.t, frame.image, track_.camera, mask);
        if (!keep) continue;
        noteMoment(track_, place, person.id, frame.t, body, true);
        if (!body || !options_.watch) continue;
        const double pause = processorSeconds();
        options_.watch({i, person.id, frame, track_.camera, *it->second.rig(), *body});
        track_.seconds -= processorSeconds() - pause;
      }
      // People not in this image are lost.
      humanmodel::SkeletonFrame none;
      none.t = frame.t;
      for (const auto& [id, k] : place)
        if (track_.people[k].frames.back().t < frame.t) track_.people[k].frames.push_back(none);
      if (!keep) continue;
      track_.seconds += processorSeconds() - begin;
      ++track_.images;
      if (options_.progress) options_.progress(i + 1, stream_.size());
    }
    for (auto& [id, person] : trackers) {
      if (!keep) {
        person.settle();
        person.settle();
      }
      if (!person.body()) continue;
      learned.insert_or_assign(id, KnownBody{*person.body(), person.stature(), person.facing()});
      if (!keep || place.count(id) == 0) continue;
      track_.people[place[id]].body = *person.body();
      track_.people[place[id]].facing = person.facing();
      track_.people[place[id]].stature = person.stature();
    }
  }

  DepthStream& stream_;
  const ClipTrackerOptions& options_;
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
    for (double& spread : person.frames.back().spread) spread = std::hypot(spread, track.camera.spread);
  }
  if (!body || !body->found) return;
  ++person.found;
  person.residual += body->misfit.residual;
}

void finishTrack(ClipTrack& track) {
  for (ClipPerson& person : track.people)
    person.residual /= std::max<double>(1.0, static_cast<double>(person.found));
  std::stable_sort(track.people.begin(), track.people.end(),
                   [](const ClipPerson& a, const ClipPerson& b) { return a.found > b.found; });
}

ClipTrack trackClip(DepthStream& stream, const ClipTrackerOptions& options) {
  return ClipPasses(stream, options).run();
}

}  // namespace abstand::tracking
