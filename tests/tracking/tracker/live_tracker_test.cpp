// One walk through images as they come.
#include "tracking/tracker/live_tracker.hpp"

#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/posed_person.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"

namespace abstand::testing {
namespace live_tracker_test {

// m; twice what two walks with a fitted body leave on the mean (docs/tracking.md), as here the body is the
// usual one.
constexpr double kOfLiveBody = 0.08;

constexpr int kMaxImages = 20000;  // some minutes; a body is fitted in seconds, also under a sanitizer

constexpr double kFloorNoise = 0.05;  // m, at 3 m from a Kinect (tracking/depth/README.md)

SimulatedClip someoneReaching(double end, bool room = false) {
  return simulate({.recording = projectFile("data/scenes/hug_reach.bvh"), .end = end, .room = room});
}

/// The usual body, of that height or of the measured one.
tracking::LiveTrackerOptions usual(std::optional<double> height) {
  tracking::LiveTrackerOptions options;
  options.person.height = height;
  options.person.fit_body = false;
  return options;
}

TEST(LiveTracker, ProcessesEveryImageOnce) {
  SimulatedClip clip = someoneReaching(1.5);
  tracking::LiveTrackerOptions options = usual(1.75);
  std::size_t watched = 0;
  options.watch = [&](const tracking::ClipMoment& moment) { EXPECT_EQ(moment.image, watched++); };
  tracking::LiveTracker tracker({&clip.stream->camera(), 1}, true, options);
  std::vector<humanmodel::SkeletonFrame> seen;
  tracking::DepthFrame frame;
  while (clip.stream->next(frame)) {
    const auto people = tracker.see(frame);
    ASSERT_EQ(people.size(), 1u) << frame.t;
    EXPECT_EQ(people[0].id, 1);
    seen.push_back(people[0].body->frame);
    EXPECT_EQ(seen.back().t, frame.t);
  }
  EXPECT_EQ(watched, clip.stream->size());
  const JointErrors errors = compare(seen, clip.truth);
  EXPECT_LE(JointErrors::mean(errors.raw), kOfLiveBody);
  EXPECT_EQ(errors.lost, 0u);
  const tracking::ClipTrack track = tracker.track();
  ASSERT_EQ(track.people.size(), 1u);
  EXPECT_EQ(track.people[0].found, clip.stream->size());
  EXPECT_EQ(track.people[0].frames.size(), clip.stream->size());
  EXPECT_EQ(track.people[0].body.height, 1.75);
  EXPECT_GT(track.people[0].residual, 0.0);
  EXPECT_LT(track.people[0].residual, 0.03);
  EXPECT_EQ(track.world, "the camera pose is taken from its file");
}

/// Fitting on a thread of its own comes to the same body, later, and nobody is lost meanwhile.
TEST(LiveTracker, BackgroundFitMatchesInlineFit) {
  const auto fitted = [](bool aside) {
    SimulatedClip clip = someoneReaching(4.0);
    tracking::LiveTrackerOptions options;
    options.person.height = 1.75;
    options.person.fit_aside = aside;
    tracking::LiveTracker tracker({&clip.stream->camera(), 1}, true, options);
    tracking::DepthFrame frame;
    tracking::DepthImage before;
    int lost = 0, images = 0;
    for (; images < kMaxImages; ++images) {
      // The last images, one after the other, stay until the body is there: equal ones are those of a camera
      // that hangs.
      const double t = frame.t;
      if (!clip.stream->next(frame)) {
        std::swap(frame.image, before);
        frame.t = t + 1.0 / 30.0;
      } else if (static_cast<std::size_t>(images) + 2 == clip.stream->size()) {
        before = frame.image;
      }
      lost += tracker.see(frame).empty();
      const bool over = static_cast<std::size_t>(images) >= clip.stream->size();
      if (over && !tracker.track().people.at(0).body.overrides.empty()) break;
    }
    EXPECT_LT(images, kMaxImages);
    EXPECT_EQ(lost, 0);
    return tracker.track().people.at(0).body;
  };
  const humanmodel::HumanModel aside = humanmodel::makeHuman(fitted(true)),
                               at_once = humanmodel::makeHuman(fitted(false));
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i) {
    const auto part = static_cast<humanmodel::BodyPart>(i);
    EXPECT_EQ(aside.part(part).length, at_once.part(part).length);
    EXPECT_EQ(aside.part(part).contour, at_once.part(part).contour);
  }
}

/// Measured first: nobody to send, then somebody of about the right height.
TEST(LiveTracker, MeasuresUnknownPerson) {
  SimulatedClip clip = someoneReaching(0.7);
  tracking::LiveTrackerOptions options = usual(std::nullopt);
  options.keep = false;
  tracking::LiveTracker tracker({&clip.stream->camera(), 1}, true, options);
  tracking::DepthFrame frame;
  std::size_t first = 0, images = 0;
  while (clip.stream->next(frame)) {
    ++images;
    if (!tracker.see(frame).empty() && first == 0) first = images;
  }
  EXPECT_GT(first, 1u);
  EXPECT_LT(first, images);
  const tracking::ClipTrack track = tracker.track();
  ASSERT_EQ(track.people.size(), 1u);
  EXPECT_NEAR(track.people[0].body.height.value(), 1.75, 0.08);
  EXPECT_TRUE(track.people[0].frames.empty()) << "nothing is kept";
}

/// Where the camera does not say how it stands, the floor does, and nothing is tracked before.
TEST(LiveTracker, UsesDetectedFloor) {
  SimulatedClip clip = someoneReaching(0.3, true);
  tracking::DepthCamera camera = clip.stream->camera();
  const Transform X_WC = camera.X_WC;
  camera.X_WC = Transform::Identity();
  tracking::LiveTracker tracker({&camera, 1}, false, usual(1.75));
  tracking::DepthFrame frame;
  while (clip.stream->next(frame)) tracker.see(frame);
  const tracking::ClipTrack track = tracker.track();
  EXPECT_EQ(track.world, "the visible floor is z = 0");
  // Height and tilt are those of the true camera; where it stands on the floor nobody can know.
  EXPECT_NEAR(track.camera.X_WC.translation().z(), X_WC.translation().z(), kFloorNoise);
  EXPECT_NEAR((track.camera.X_WC.linear().row(2) - X_WC.linear().row(2)).norm(), 0.0, 0.02);

  tracking::LiveTracker blind({&camera, 1}, false, {});
  frame.image = tracking::DepthImage(camera.width, camera.height);
  for (int i = 0; i < 10; ++i) {
    frame.t = 0.1 * i;
    EXPECT_TRUE(blind.see(frame).empty());
  }
  EXPECT_EQ(blind.track().world, "undetermined: no image");
  EXPECT_TRUE(blind.track().people.empty());
}

/// What one camera does not see, the other does, and both know less than exact places of the cameras.
TEST(LiveTracker, SeveralCamerasShareOneFit) {
  const std::vector<Posture> postures{{.t = 0.0}, {.t = 0.7, .reach = 0.4}, {.t = 1.4}};
  const std::vector<FurnitureBox> bench{{{0.45, -0.8, 0.0}, {0.95, 0.8, 0.9}}};
  const auto seenBy = [&](const Vector3d& eye) {
    return simulate({.recording = {}, .eye = eye, .look = {0.0, 0.0, 0.9}, .room = true},
                    posedFrames(postures), bench);
  };
  SimulatedClip front = seenBy({2.8, 0.0, 1.6}), side = seenBy({0.0, -2.8, 1.6});
  std::vector<tracking::DepthCamera> cameras{front.stream->camera(), side.stream->camera()};
  cameras[1].spread = 0.03;
  tracking::LiveTracker tracker(cameras, true, usual(1.75));
  // The second camera runs 10 ms later.
  const std::vector<tracking::ClipCamera> streams{{front.stream.get(), 0.0}, {side.stream.get(), 0.01}};
  tracking::DepthMoments moments(streams);
  tracking::DepthMoment moment;
  std::vector<humanmodel::SkeletonFrame> seen;
  while (moments.next(moment)) {
    const auto people = tracker.see(moment);
    ASSERT_EQ(people.size(), 1u) << moment.t;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      const bool is_known = people[0].frame.has(static_cast<humanmodel::Joint>(j));
      EXPECT_FALSE(is_known && people[0].frame.spread[j] < cameras[1].spread) << j;
    }
    seen.push_back(people[0].frame);
  }
  const JointErrors errors = compare(seen, front.truth);
  EXPECT_EQ(errors.lost, 0u);
  EXPECT_LE(JointErrors::mean(errors.raw), kOfLiveBody) << "also of the legs behind the bench";
  EXPECT_GE(errors.tracked.within(), 0.99);
  const tracking::ClipTrack track = tracker.track();
  ASSERT_EQ(track.cameras.size(), 2u);
  EXPECT_EQ(track.cameras[1].people, track.cameras[1].images);
  EXPECT_NEAR(track.lag, 0.01, 1e-9);
  EXPECT_EQ(track.people.at(0).frames.back().spread, seen.back().spread) << "what is kept is what is sent";
  EXPECT_THROW(tracking::LiveTracker(cameras, false, usual(1.75)), UsageError);
}

/// Nobody is tracked by a camera whose pose is not known any more, and what it said before that was known is
/// taken back.
TEST(LiveTracker, MovedCameraIsNotUsed) {
  constexpr double kPushed = 0.8;
  auto clip = simulate(
      {.recording = {}, .room = true, .width = 160, .push_at = kPushed - 1e-6, .push = unit::deg(4.0)},
      posedFrames(std::vector<Posture>{{.t = 0.0}, {.t = 1.6, .reach = 0.4}}), {});
  tracking::LiveTracker tracker({&clip.stream->camera(), 1}, true, usual(1.75));
  tracking::DepthFrame frame;
  double last = 0.0;
  while (clip.stream->next(frame))
    if (!tracker.see(frame).empty()) last = frame.t;
  const double moved_at = tracker.shares().front().moved_at;
  EXPECT_NEAR(moved_at, kPushed, 1.5 / 30.0);
  EXPECT_LE(last, moved_at + tracking::CameraWatch::kLasts + 1.5 / 30.0);
  const tracking::ClipTrack track = tracker.track();
  for (const humanmodel::SkeletonFrame& kept : track.people.at(0).frames)
    EXPECT_FALSE(kept.t >= moved_at && kept.has(humanmodel::Joint::kPelvis)) << kept.t;
}

/// A camera that sends the same image again and again would show somebody who stands still.
TEST(LiveTracker, HungCameraIsNotUsed) {
  constexpr double kHung = 0.2;  // s, as in the tracker
  SimulatedClip clip = someoneReaching(1.0);
  tracking::LiveTracker tracker({&clip.stream->camera(), 1}, true, usual(1.75));
  tracking::DepthFrame frame;
  for (int i = 0; i < 15; ++i) {
    ASSERT_TRUE(clip.stream->next(frame));
    EXPECT_EQ(tracker.see(frame).size(), 1u) << frame.t;
  }
  const double last = frame.t;
  for (int i = 1; i < 15; ++i) {
    frame.t = last + i / 30.0;
    EXPECT_EQ(tracker.see(frame).empty(), frame.t - last >= kHung) << frame.t;
  }
  EXPECT_EQ(tracker.shares().front().hung_at, last);
  const double since = frame.t;
  ASSERT_TRUE(clip.stream->next(frame));
  frame.t = since + 1.0 / 30.0;
  EXPECT_EQ(tracker.see(frame).size(), 1u) << "it sends images again";
}

/// Somebody whom a beam touches that moves: the errors of the joints if it is removed where `known_at` has it
/// (boxes), or not at all.
struct BesideABeam {
  const std::vector<FurnitureBox> beam{
      {.low = {0.12, -1.4, 1.05}, .high = {0.24, 0.0, 1.2}, .swing = {0.0, 0.15, 0.0}}};
  std::vector<FurnitureBox> known_at;
  JointErrors errors;
  std::vector<tracking::ShownThings> shown;

  explicit BesideABeam(const Vector3d& aside, bool is_known = true) {
    const SimulatedClip standing = someoneReaching(1.5, true);
    SimulatedClip clip =
        simulate({.recording = projectFile("data/scenes/hug_reach.bvh"), .room = true}, standing.truth, beam);
    known_at = beam;
    for (FurnitureBox& box : known_at) box.low += aside, box.high += aside;
    tracking::DepthImage image;
    tracking::LiveTrackerOptions options = usual(1.75);
    if (is_known)
      options.known = [&](double t, const tracking::DepthCamera& camera) {
        image = depthOf(known_at, t, camera);
        return &image;
      };
    options.at_rest = options.known;
    tracking::LiveTracker tracker({&clip.stream->camera(), 1}, true, options);
    std::vector<humanmodel::SkeletonFrame> seen;
    tracking::DepthFrame frame;
    while (clip.stream->next(frame)) {
      const auto people = tracker.see(frame);
      humanmodel::SkeletonFrame none;
      none.t = frame.t;
      seen.push_back(people.empty() ? none : people[0].frame);
    }
    errors = compare(seen, clip.truth);
    shown.assign(tracker.shown().begin(), tracker.shown().end());
  }
};

TEST(LiveTracker, ThingsThatAreKnownAreNotPartsOfPeople) {
  const BesideABeam removed(Vector3d::Zero()), kept(Vector3d::Zero(), false);
  EXPECT_TRUE(removed.shown[0].areShown());
  EXPECT_GT(removed.shown[0].share(), 0.9);
  EXPECT_EQ(removed.errors.lost, 0u);
  EXPECT_LE(JointErrors::mean(removed.errors.raw), kOfLiveBody);
  EXPECT_LT(JointErrors::mean(removed.errors.raw), JointErrors::mean(kept.errors.raw));
}

/// A robot whose joint values are not accurate: the whole beam hides, and is no part of the person, nor in
/// the hand.
TEST(LiveTracker, ThingsThatAreDisplacedHide) {
  const BesideABeam displaced(Vector3d(0.0, 0.0, 0.08)), exact(Vector3d::Zero());
  EXPECT_EQ(exact.shown[0].displaced().band(), 0.0);
  EXPECT_TRUE(displaced.shown[0].areShown());
  EXPECT_GE(displaced.shown[0].displaced().band(), 0.08);
  EXPECT_EQ(displaced.errors.lost, 0u);
  EXPECT_LE(JointErrors::mean(displaced.errors.raw), kOfLiveBody);
  EXPECT_GE(displaced.errors.tracked.within(), 0.99);
}

// A beam that is said to be 0.5 m above its place is not removed there, where the person's head is.
TEST(LiveTracker, ThingsThatAreElsewhereAreNotRemoved) {
  const BesideABeam wrong(Vector3d(0.0, 0.0, 0.5)), kept(Vector3d::Zero(), false);
  EXPECT_FALSE(wrong.shown[0].areShown());
  EXPECT_LT(wrong.shown[0].share(), tracking::ShownThings::kElsewhere);
  EXPECT_LE(wrong.errors.lost, kept.errors.lost + 1);
}

TEST(LiveTracker, ReportsLeavingPersonLost) {
  SimulatedClip clip = someoneReaching(0.2);
  tracking::LiveTracker tracker({&clip.stream->camera(), 1}, true, usual(1.75));
  tracking::DepthFrame frame;
  while (clip.stream->next(frame)) tracker.see(frame);
  const std::size_t with = clip.stream->size();
  frame.image = tracking::DepthImage(frame.image.width, frame.image.height);
  // Longer than anybody is remembered.
  for (int i = 1; i <= 15; ++i) {
    frame.t += 1.0;
    EXPECT_TRUE(tracker.see(frame).empty()) << i;
  }
  const tracking::ClipTrack track = tracker.track();
  ASSERT_EQ(track.people.size(), 1u);
  EXPECT_EQ(track.people[0].found, with);
  EXPECT_GT(track.people[0].frames.size(), with);
  EXPECT_LT(track.people[0].frames.size(), with + 15) << "who is gone for good is no longer noted as lost";
  EXPECT_FALSE(track.people[0].frames.back().has(humanmodel::Joint::kPelvis));
}

}  // namespace live_tracker_test
}  // namespace abstand::testing
