// Depth recordings from end to end: people who come and go.
#include "tracking/tracker/clip_tracker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/registry/open_recording.hpp"
#include "tracking/tracker/tracked_recording.hpp"

namespace abstand::tracking {
namespace clip_tracker_test {

TEST(ClipTracker, FindsFivePeople) {
  const auto cloud = testing::sharedData("depth/pcl/five_people.pcd");
  if (!exists(cloud)) GTEST_SKIP() << cloud;
  const auto stream = openDepthStream(cloud);
  const ClipTrack track = trackClip(*stream, {});
  EXPECT_EQ(track.people.size(), 5u);
  EXPECT_EQ(track.images, 1u);
}

TEST(ClipTracker, PersonOutsideImageIsReportedLost) {
  testing::ClipPlan plan{.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 1.6};
  auto clip = testing::simulate(plan);
  DepthSource source;
  source.camera = clip.stream->camera();
  source.facts = clip.stream->facts();
  source.t = clip.stream->times();
  std::vector<DepthImage> images;
  for (DepthFrame frame; clip.stream->next(frame);) images.push_back(frame.image);
  constexpr std::size_t kGone = 20, kBack = 30;
  source.load = [&](std::size_t i) {
    return i >= kGone && i < kBack ? DepthImage(images[i].width, images[i].height) : images[i];
  };
  DepthStream stream(std::move(source));
  const ClipTrack track = trackClip(stream, {});
  ASSERT_EQ(track.people.size(), 1u);
  const std::vector<humanmodel::SkeletonFrame>& frames = track.people[0].frames;
  ASSERT_EQ(frames.size(), images.size());
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_EQ(frames[i].has(humanmodel::Joint::kPelvis), i < kGone || i >= kBack) << "image " << i;
  EXPECT_EQ(track.people[0].found, frames.size() - (kBack - kGone));
}

// Images without the upper part of the person, of whom there is no head: the body of the first image with a
// head is tracked backwards through them.
TEST(ClipTracker, TracksBackwardsWhoIsFoundLater) {
  constexpr std::size_t kFirstHead = 12;  // first image with a head
  constexpr double kNeckHeight = 1.45;    // m
  constexpr double kLegs = 0.05;          // m, raw mean error of what is seen of the legs. Measured: 0.025
  testing::ClipPlan plan{
      .recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 1.6, .room = true};
  auto clip = testing::simulate(plan);
  const DepthCamera camera = clip.stream->camera();
  DepthSource source{.camera = camera, .facts = clip.stream->facts(), .t = clip.stream->times()};
  std::vector<DepthImage> images;
  for (DepthFrame frame; clip.stream->next(frame);) images.push_back(frame.image);
  source.load = [&](std::size_t i) {
    DepthImage image = images[i];
    for (int v = 0; v < image.height && i < kFirstHead; ++v)
      for (int u = 0; u < image.width; ++u) {
        float& z = image.z[static_cast<std::size_t>(v * image.width + u)];
        if ((camera.X_WC * camera.at(u, v, static_cast<double>(z))).z() > kNeckHeight) z = 0.0f;
      }
    return image;
  };
  std::vector<std::size_t> shown;
  ClipTrackerOptions options;
  options.watch = [&](const ClipMoment& moment) { shown.push_back(moment.image); };
  DepthStream stream(std::move(source));
  const ClipTrack track = trackClip(stream, options);
  ASSERT_EQ(track.people.size(), 1u);
  const std::vector<humanmodel::SkeletonFrame>& frames = track.people[0].frames;
  ASSERT_EQ(frames.size(), images.size());
  EXPECT_EQ(track.people[0].found, images.size());
  ASSERT_EQ(shown.size(), images.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(shown[i], i);
    EXPECT_EQ(frames[i].t, clip.truth[i].t);
  }
  double sum = 0.0;
  using enum humanmodel::Joint;
  const std::array legs{kKneeLeft, kKneeRight, kAnkleLeft, kAnkleRight};
  for (std::size_t i = 0; i < kFirstHead; ++i)
    for (const humanmodel::Joint joint : legs) sum += (frames[i][joint] - clip.truth[i][joint]).norm();
  EXPECT_LE(sum / static_cast<double>(kFirstHead * legs.size()), kLegs);
}

TEST(ClipTracker, MeasuresStature) {
  constexpr double kTolerance = 0.05;  // m: hair, soles, and what the noise takes off
  testing::ClipPlan plan{.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 0.8};
  auto clip = testing::simulate(plan);
  const ClipTrack track = trackClip(*clip.stream, {});
  ASSERT_EQ(track.people.size(), 1u);
  EXPECT_NEAR(track.people[0].body.height.value(), clip.truth[0][humanmodel::Joint::kHeadTop].z(),
              kTolerance);
  ClipTrackerOptions options;
  options.person.height = 1.85;
  const ClipTrack told = trackClip(*clip.stream, options);
  EXPECT_DOUBLE_EQ(told.people[0].body.height.value(), 1.85);
}

TEST(ClipTracker, IsDeterministic) {
  testing::ClipPlan plan{.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 0.8};
  auto clip = testing::simulate(plan);
  const ClipTrack a = trackClip(*clip.stream, {}), b = trackClip(*clip.stream, {});
  for (std::size_t i = 0; i < a.people[0].frames.size(); ++i)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      EXPECT_EQ(a.people[0].frames[i].p[j], b.people[0].frames[i].p[j]);
}

TEST(BodyTracker, AllocatesNothingWhileFollowing) {
  testing::ClipPlan plan{.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 0.2};
  auto clip = testing::simulate(plan);
  static const BodyRig rig = makeRig(humanmodel::makeHuman({}));
  BodyTracker tracker(rig);
  for (DepthFrame frame; clip.stream->next(frame);) {
    std::vector<std::uint8_t> mask(frame.image.z.size());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = frame.image.z[i] > 0.0f;
    const bool follows = tracker.body().found;
    const PersonImage image{&frame.image, &clip.stream->camera(), mask};
    testing::NoAlloc guard;
    tracker.track(frame.t, {&image, 1});
    if (follows) {
      EXPECT_EQ(guard.count(), 0);
    }
  }
  EXPECT_TRUE(tracker.body().found);
}

TEST(TrackedRecording, DetectsDepthByContent) {
  EXPECT_TRUE(isDepthRecording(testing::projectFile("data")));
  EXPECT_FALSE(isDepthRecording(testing::projectFile("data/scenes/hug_reach.bvh")));
  EXPECT_FALSE(isDepthRecording("no/such/file"));
  const auto skeleton = testing::sharedData("depth/utd_mhad/a18_s1_t1_skeleton.mat");
  if (!exists(skeleton)) GTEST_SKIP() << skeleton;
  EXPECT_FALSE(isDepthRecording(skeleton));
  EXPECT_TRUE(isDepthRecording(testing::sharedData("depth/utd_mhad/a18_s1_t1_depth.mat")));
  EXPECT_TRUE(isDepthRecording(testing::sharedData("depth/pcl/five_people.pcd")));
}

TEST(TrackedRecording, RejectsMissingPerson) {
  ClipTrack track;
  try {
    recordingOf(track, {}, 0);
    FAIL() << "gave one";
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("found 0 people"));
  }
}

}  // namespace clip_tracker_test
}  // namespace abstand::tracking
