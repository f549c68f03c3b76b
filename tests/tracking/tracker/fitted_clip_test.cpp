// The bodies that are kept of a tracked clip, against the recording that comes of it.
#include "tracking/tracker/fitted_clip.hpp"

#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/tracker/track_picture.hpp"

namespace abstand::tracking {
namespace fitted_clip_test {

constexpr double kRounding = 1e-9;  // m

struct FittedClipTest : ::testing::Test {
  void track(std::size_t gone_from, std::size_t gone_to) {
    testing::ClipPlan plan{.recording = testing::projectFile("data/scenes/hug_reach.bvh"), .end = 0.8};
    auto clip = testing::simulate(plan);
    DepthSource source;
    source.camera = clip.stream->camera();
    source.facts = clip.stream->facts();
    source.t = clip.stream->times();
    for (DepthFrame frame; clip.stream->next(frame);) images.push_back(frame.image);
    source.load = [=, this](std::size_t i) {
      return i >= gone_from && i < gone_to ? DepthImage(images[i].width, images[i].height) : images[i];
    };
    DepthStream stream(std::move(source));
    FitLog fits;
    ClipTrackerOptions options;
    options.watch = [&](const ClipMoment& moment) { fits.note(moment); };
    result = trackClip(stream, options);
    ASSERT_EQ(result.people.size(), 1u);
    fitted = fits.clipOf(result, 0, stream);
  }
  std::vector<DepthImage> images;
  ClipTrack result;
  FittedClip fitted;
};

TEST_F(FittedClipTest, BodyOfEachImageHasJointsOfRecording) {
  constexpr std::size_t kGone = 12, kBack = 15;
  track(kGone, kBack);
  ASSERT_EQ(fitted.images.size(), images.size());
  ASSERT_EQ(result.people[0].frames.size(), images.size());
  std::size_t found = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const FittedImage& image = fitted.images[i];
    const humanmodel::SkeletonFrame& frame = result.people[0].frames[i];
    EXPECT_EQ(image.found, frame.has(humanmodel::Joint::kPelvis)) << i;
    EXPECT_EQ(image.joints.t, fitted.times[i]);
    EXPECT_EQ(image.joints.spread, frame.spread);
    if (!image.found) continue;
    ++found;
    RigPlacement X_WS;
    place(*image.rig, image.pose, X_WS);
    humanmodel::SkeletonFrame joints;
    jointsOf(*image.rig, X_WS, humanmodel::JointState::kTracked, joints);
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      if (frame.state[j] == humanmodel::JointState::kMissing) continue;
      EXPECT_LE((joints.p[j] - frame.p[j]).norm(), kRounding) << "image " << i << " joint " << j;
    }
  }
  EXPECT_EQ(found, result.people[0].found);
  EXPECT_EQ(found, images.size() - (kBack - kGone));
}

TEST_F(FittedClipTest, ImageAtIsLastOneBegun) {
  fitted.times = {0.5, 0.6, 0.8};
  EXPECT_EQ(fitted.imageAt(-1.0), 0u);
  EXPECT_EQ(fitted.imageAt(0.5), 0u);
  EXPECT_EQ(fitted.imageAt(0.59), 0u);
  EXPECT_EQ(fitted.imageAt(0.6), 1u);
  EXPECT_EQ(fitted.imageAt(0.79), 1u);
  EXPECT_EQ(fitted.imageAt(9.0), 2u);
}

TEST_F(FittedClipTest, BodyIsDrawnOverPersonOnly) {
  track(1000, 1000);
  const FittedImage& last = fitted.images.back();
  ASSERT_TRUE(last.found);
  const DepthImage& image = images.back();
  ColourImage plain(image.width, image.height);
  drawDepth(image, 0, plain);
  ColourImage drawn = plain;
  RigPlacement X_WS;
  place(*last.rig, last.pose, X_WS);
  drawBody(image, fitted.camera, *last.rig, X_WS, 0, drawn);
  std::size_t person = 0, coloured = 0, beside = 0;
  for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
    const bool measured = image.z[i] > 0.0f;
    const bool changed = drawn.pixels[i] != plain.pixels[i];
    person += measured;
    coloured += measured && changed;
    beside += !measured && changed;
  }
  // Nothing but the person is in this clip. The body's shapes are no skin: they miss a part of it, and stand
  // out beside it.
  constexpr double kCovered = 0.7, kBeside = 0.3;
  EXPECT_GT(static_cast<double>(coloured), kCovered * static_cast<double>(person));
  EXPECT_LT(static_cast<double>(beside), kBeside * static_cast<double>(person));
}

}  // namespace fitted_clip_test
}  // namespace abstand::tracking
