// Walking through a stream: who is where, and the body of each.
#include "tracking/tracker/clip_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "tracking/depth/people_finder.hpp"

namespace abstand {
namespace {

constexpr double kLearning = 5.0;  // s of the stream that sizes are learned from
constexpr std::size_t kFloorImages = 5;

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Camera over a plane: z up, x along the level part of the optical axis, the origin below the camera.
Transform overFloor(const FloorPlane& floor) {
  const Vector3d z = floor.up.normalized();
  Vector3d x = Vector3d::UnitZ() - z.z() * z;
  x = x.norm() > 1e-3 ? Vector3d(x.normalized()) : z.unitOrthogonal();
  Matrix3d R_WC;
  R_WC.row(0) = x.transpose();
  R_WC.row(1) = z.cross(x).transpose();
  R_WC.row(2) = z.transpose();
  Transform X_WC = Transform::Identity();
  X_WC.linear() = R_WC;
  X_WC.translation() = Vector3d(0.0, 0.0, floor.height);
  return X_WC;
}

/// Lowest point of anyone in an image, m, z of the world.
double lowest(const DepthImage& image, const DepthCamera& camera, const PeopleImage& people) {
  double z = kInfinity;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u)
      if (people.label[static_cast<std::size_t>(v * image.width + u)] != 0)
        z = std::min(z, (camera.X_WC * camera.at(u, v, static_cast<double>(image.at(u, v)))).z());
  return z;
}

class Walk {
 public:
  Walk(DepthStream& stream, const ClipTrackerOptions& options) : stream_{stream}, options_{options} {}

  ClipTrack run() {
    track_.camera = stream_.camera();
    stand();
    std::map<int, HumanOptions> bodies;
    const std::vector<double>& times = stream_.times();
    const double end = times.empty() ? 0.0 : times.front() + kLearning;
    go(end, bodies, false);
    go(kInfinity, bodies, true);
    std::stable_sort(track_.people.begin(), track_.people.end(),
                     [](const ClipPerson& a, const ClipPerson& b) { return a.found > b.found; });
    return std::move(track_);
  }

 private:
  void stand() {
    if (stream_.facts().pose_known) {
      track_.world = "the camera's pose is that of its file";
      return;
    }
    stream_.seek(0);
    DepthFrame frame;
    PeopleFinder finder(track_.camera);
    double low = kInfinity;
    Transform level = overFloor({});
    for (std::size_t i = 0; i < kFloorImages && stream_.next(frame); ++i) {
      const PeopleImage& people = finder.find(frame.t, frame.image);
      if (people.floor) {
        track_.camera.X_WC = overFloor(*people.floor);
        track_.world = "the floor in sight is z = 0";
        return;
      }
      DepthCamera camera = track_.camera;
      camera.X_WC = level;
      low = std::min(low, lowest(frame.image, camera, people));
    }
    if (std::isfinite(low)) level.translation().z() = -low;
    track_.camera.X_WC = level;
    track_.world =
        "no floor in sight: the camera is taken to be level, the lowest that is seen of a person at z = 0";
  }

  /// All images before `end`; learns `bodies`, or tracks with them.
  void go(double end, std::map<int, HumanOptions>& bodies, bool keep) {
    stream_.seek(0);
    PeopleFinder finder(track_.camera);
    std::map<int, TrackedPerson> trackers;
    std::map<int, std::size_t> place;  // of a person in track_.people
    DepthFrame frame;
    std::vector<std::uint8_t> mask;
    for (std::size_t i = 0; stream_.next(frame) && frame.t < end; ++i) {
      if (options_.interrupted && options_.interrupted()) {
        track_.interrupted = true;
        break;
      }
      const DepthImage* known = options_.known ? options_.known(frame.t, track_.camera) : nullptr;
      const double begin = processorSeconds();
      const PeopleImage& people = finder.find(frame.t, frame.image, known);
      for (const FoundPerson& person : people.persons) {
        auto it = trackers.find(person.id);
        if (it == trackers.end()) {
          const auto body_of = bodies.find(person.id);
          it = body_of != bodies.end()
                   ? trackers.try_emplace(person.id, options_.person, body_of->second).first
                   : trackers.try_emplace(person.id, options_.person).first;
        }
        finder.mask(person.id, mask);
        const TrackedBody* body = it->second.see(frame.t, frame.image, track_.camera, mask);
        if (!keep) continue;
        note(person.id, frame.t, body, place);
        if (!body || !options_.watch) continue;
        const double pause = processorSeconds();
        options_.watch({i, person.id, frame, track_.camera, *it->second.rig(), *body});
        track_.seconds -= processorSeconds() - pause;
      }
      // Who is not in this image is lost in it.
      SkeletonFrame none;
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
      bodies.insert_or_assign(id, *person.body());
      if (keep && place.count(id) > 0) track_.people[place[id]].body = *person.body();
    }
    if (keep)
      for (ClipPerson& person : track_.people)
        person.residual /= std::max<double>(1.0, static_cast<double>(person.found));
  }

  void note(int id, double t, const TrackedBody* body, std::map<int, std::size_t>& place) {
    const auto [it, is_new] = place.try_emplace(id, track_.people.size());
    if (is_new) {
      track_.people.push_back({});
      track_.people.back().id = id;
      track_.people.back().residual = 0.0;
    }
    ClipPerson& person = track_.people[it->second];
    SkeletonFrame none;
    none.t = t;
    person.frames.push_back(body ? body->frame : none);
    for (double& spread : person.frames.back().spread) spread = std::hypot(spread, track_.camera.spread);
    if (!body || !body->found) return;
    ++person.found;
    person.residual += body->misfit.residual;
  }

  DepthStream& stream_;
  const ClipTrackerOptions& options_;
  ClipTrack track_;
};

}  // namespace

ClipTrack trackClip(DepthStream& stream, const ClipTrackerOptions& options) {
  return Walk(stream, options).run();
}

}  // namespace abstand
