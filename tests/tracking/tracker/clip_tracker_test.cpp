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
