#include "app/session/human_driver.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/safety/body_motion.hpp"
#include "humanmodel/held_tool.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "humanmodel/recording_lengths.hpp"
#include "tracking/recording/mirrored_person.hpp"
#include "tracking/recording/required_person.hpp"
#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::session {
namespace {

std::optional<tracking::Recording> recordingOf(const scene_file::HumanDescription& d,
                                               const tracking::KnownObjects& known,
                                               const tracking::TrackMonitor& monitor) {
  if (d.recording.file.empty()) return std::nullopt;
  tracking::KnownObjects objects = known;
  objects.remove = d.recording.cut_things;
  tracking::Recording recording =
      tracking::openAnyRecording(d.recording.file, d.recording.options, std::nullopt, objects, monitor);
  tracking::requirePerson(recording.report, d.recording.file.string());
  if (d.recording.mirrored) {
    try {
      tracking::mirrorPerson(recording.frames);
    } catch (const UsageError& e) {
      throw ParseError({d.recording.file.string()}, e.what());
    }
  }
  const double start = recording.frames.front().t;
  for (auto& frame : recording.frames) frame.t = start + (frame.t - start) / d.recording.speed;
  if (d.recording.speed != 1.0) recording.clock_start = kNaN;
  return recording;
}

humanmodel::HumanModel modelOf(const scene_file::HumanDescription& d,
                               const std::optional<tracking::Recording>& recording) {
  humanmodel::HumanOptions options = d.body;
  try {
    if (d.follow_lengths && recording) options = humanmodel::withRecordingLengths(options, recording->frames);
    return humanmodel::makeHuman(options);
  } catch (const UsageError& e) {
    throw ParseError(d.pos, std::string(e.what()) + " (person '" + d.name + "')");
  }
}

scene::PoseState poseState(humanmodel::PartState s) {
  switch (s) {
    case humanmodel::PartState::kTracked:
      return scene::PoseState::kFresh;
    case humanmodel::PartState::kInferred:
      return scene::PoseState::kInferred;
    case humanmodel::PartState::kHeld:
    case humanmodel::PartState::kNone:
      return scene::PoseState::kStale;
  }
  return scene::PoseState::kStale;
}

}  // namespace

HumanDriver::HumanDriver(const scene_file::HumanDescription& d, const tracking::KnownObjects& known,
                         const tracking::TrackMonitor& monitor)
    : recording_(recordingOf(d, known, monitor)),
      model_(modelOf(d, recording_)),
      poser_(model_, d.follow_lengths),
      X_WR_(fromXyzRpy(d.recording.place_xyz, Vector3d(0, 0, d.recording.place_yaw))) {
  if (recording_) poser_.calibrate(recording_->frames);
  humanmodel::Poser(model_).pose(model_.rest, standing_);
}

void HumanDriver::hold(humanmodel::BodyPart hand, ObjectId object, const Transform& X_HT, double reach) {
  held_.push_back({hand, object, X_HT, reach, humanmodel::turnLever(model_.part(hand))});
}

std::vector<HumanDriver::Body> HumanDriver::bodies() const {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i)
    if (objects_[i]) bodies.push_back({*objects_[i], static_cast<humanmodel::BodyPart>(i), false});
  for (const Held& held : held_) bodies.push_back({held.object, held.hand, true});
  return bodies;
}

std::vector<double> HumanDriver::recordedSpeeds(const scene::Scene& scene) const {
  const std::vector<Body> all = bodies();
  std::vector<double> fastest(all.size(), 0.0);
  if (!recording_) return fastest;
  struct Last {
    Transform X;
    double t{kNaN};
  };
  std::vector<Last> last(all.size());
  humanmodel::Poser poser = poser_;
  poser.reset();
  humanmodel::HumanPose pose;
  for (const humanmodel::SkeletonFrame& frame : recording_->frames) {
    poser.pose(frame, pose);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t part = humanmodel::index(all[i].part);
      if (poseState(pose.state[part]) == scene::PoseState::kStale) continue;
      Transform X = pose.X_WP[part];
      for (const Held& held : held_)
        if (held.object == all[i].object) X = X * held.X_HT;
      if (frame.t > last[i].t) {
        const auto& sphere = scene.object(all[i].object).spec.structure->bounding_sphere;
        const double duration = frame.t - last[i].t;
        const safety::PoseSegment motion(sphere, last[i].X, X, duration);
        fastest[i] = std::max(fastest[i], motion.speed(0.0, duration));
      }
      last[i] = {X, frame.t};
    }
  }
  return fastest;
}

Transform HumanDriver::poseOf(std::size_t part) const {
  if (pose_.state[part] != humanmodel::PartState::kNone) return pose_.X_WP[part];
  constexpr auto kTorso = static_cast<std::size_t>(humanmodel::BodyPart::kTorso);
  if (pose_.state[kTorso] == humanmodel::PartState::kNone) return standing_.X_WP[part];
  return pose_.X_WP[kTorso] * standing_.X_WP[kTorso].inverse() * standing_.X_WP[part];
}

void HumanDriver::show(const humanmodel::SkeletonFrame& frame, double t, scene::Scene& scene) {
  if (t < last_t_) poser_.reset();
  last_t_ = t;
  poser_.pose(frame, pose_);
  place(t, scene);
}

void HumanDriver::apply(double t, scene::Scene& scene) {
  show(recording_ ? recording_->at(t) : model_.rest, t, scene);
}

void HumanDriver::interpolate(double t, scene::Scene& scene) {
  if (!recording_) return apply(t, scene);
  const humanmodel::SkeletonFrame& before = recording_->at(t);
  if (&before == &recording_->frames.back() || t < before.t) return show(before, t, scene);
  const humanmodel::SkeletonFrame& after = *(&before + 1);
  const double u = (t - before.t) / (after.t - before.t);
  humanmodel::SkeletonFrame frame = before;
  frame.t = t;
  for (std::size_t i = 0; i < humanmodel::kJointCount; ++i)
    if (before.has(static_cast<humanmodel::Joint>(i)) && after.has(static_cast<humanmodel::Joint>(i)))
      frame.p[i] += u * (after.p[i] - before.p[i]);
  show(frame, t, scene);
}

double HumanDriver::recordedAge() const {
  double oldest = 0.0;
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i)
    if (pose_.state[i] != humanmodel::PartState::kNone && std::isfinite(pose_.age[i]))
      oldest = std::max(oldest, pose_.age[i]);
  return oldest;
}

void HumanDriver::follow(const humanmodel::SkeletonFrame& frame, scene::Scene& scene) {
  if (!followed_) poser_.reset();
  followed_ = true;
  last_t_ = frame.t;
  poser_.pose(frame, pose_);
  place(frame.t, scene);
}

void HumanDriver::markStale(double t, scene::Scene& scene) const {
  const auto mark = [&](ObjectId object) {
    scene.setPose(object, scene.object(object).X_WB, t, scene::PoseState::kStale);
  };
  for (const auto& object : objects_)
    if (object) mark(*object);
  for (const Held& held : held_) mark(held.object);
  growUncertainty(t, scene);
}

void HumanDriver::growUncertainty(double t, scene::Scene& scene) const {
  const double since = std::max(0.0, t - last_t_);
  std::array<double, humanmodel::kBodyPartCount> all{}, aged{};
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i) {
    if (!objects_[i]) continue;
    const double bound = scene.object(*objects_[i]).max_speed;
    // A bound of 0 is for a person who stands still in the scene; it does not hold for a followed one.
    const double speed = std::isfinite(bound) && bound > 0.0 ? bound : humanmodel::kPersonSpeed;
    const double age = pose_.age[i] + since;
    all[i] = humanmodel::partUncertainty(age, pose_.spread[i], speed);
    aged[i] = humanmodel::ageUncertainty(age, speed);
    const Matrix3d E_R = humanmodel::kSpreadQuantile * humanmodel::kSpreadQuantile * pose_.covariance[i];
    scene.setPoseUncertainty(*objects_[i], all[i], aged[i],
                             X_WR_.linear() * E_R * X_WR_.linear().transpose());
  }
  for (const Held& held : held_) {
    const std::size_t hand = humanmodel::index(held.hand);
    const double whole = humanmodel::heldUncertainty(all[hand], held.reach, held.lever);
    const double fresh =
        humanmodel::heldUncertainty(std::max(0.0, all[hand] - aged[hand]), held.reach, held.lever);
    scene.setPoseUncertainty(held.object, whole, std::isfinite(whole) ? whole - fresh : whole);
  }
}

double HumanDriver::liveAge(double t) const {
  if (!followed_) return kInfinity;
  return *std::max_element(pose_.age.begin(), pose_.age.end()) + t - last_t_;
}

void HumanDriver::place(double t, scene::Scene& scene) const {
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i)
    if (objects_[i]) scene.setPose(*objects_[i], X_WR_ * poseOf(i), t, poseState(pose_.state[i]));
  for (const Held& held : held_) {
    const std::size_t hand = humanmodel::index(held.hand);
    scene.setPose(held.object, X_WR_ * poseOf(hand) * held.X_HT, t, poseState(pose_.state[hand]));
  }
  growUncertainty(t, scene);
}

}  // namespace abstand::session
