// People who walk into the image: the body is not searched for by a shoulder.
#include "tests/tracking/tracker/coming_in.hpp"

#include <gtest/gtest.h>

#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/live_tracker.hpp"

namespace abstand::testing {
namespace coming_in_test {

constexpr double kWithin = 0.99, kHiddenWithin = 0.97;  // shares
constexpr double kMean = 0.040;                         // m, raw, of tracked joints. Measured: 0.025 to 0.031
constexpr double kOfLiveBody = 0.060;                   // m, likewise, of the usual body. Measured: 0.032
// From here on more than half of the person is in the image.
constexpr double kInView = 1.5;  // m
const ClipPlan kPlan{.recording = {}, .room = true, .width = 240};

/// The body is found whenever half of the person is in the image, and its error is small. Returns the errors.
JointErrors expectTracked(const std::vector<humanmodel::SkeletonFrame>& truth,
                          const tracking::ClipTrack& track) {
  EXPECT_EQ(track.people.size(), 1u);
  if (track.people.empty()) return {};
  const auto is_in_view = [](const humanmodel::SkeletonFrame& frame) {
    return frame[humanmodel::Joint::kPelvis].y() < kInView;
  };
  EXPECT_GE(static_cast<std::ptrdiff_t>(track.people[0].found),
            std::count_if(truth.begin(), truth.end(), is_in_view));
  const JointErrors errors = compare(track.people[0].frames, truth);
  EXPECT_LE(JointErrors::mean(errors.tracked.error), kMean);
  return errors;
}

TEST(ComingIn, IsTrackedFromTheFirstImage) {
  struct {
    double speed;  // m/s
    std::uint64_t seed;
  } const kCases[] = {{0.4, 1}, {1.2, 1}, {1.2, 3}};
  JointErrors::Stated tracked, inferred;
  for (const auto& [speed, seed] : kCases) {
    SCOPED_TRACE(seed);
    SimulatedClip clip = simulate(kPlan, comingIn(0.0, -0.5 / speed, 3.0 / speed, speed), {});
    tracking::ClipTrackerOptions options;
    options.person.seed = seed;
    const JointErrors errors = expectTracked(clip.truth, trackClip(*clip.stream, options));
    tracked.add(errors.tracked);
    inferred.add(errors.inferred);
  }
  EXPECT_GE(tracked.within(), kWithin);
  EXPECT_GE(inferred.within(), kHiddenWithin);
}

// Nobody is there in the first seconds, which once were all that the first pass saw.
TEST(ComingIn, LaterPersonIsMeasuredFirst) {
  constexpr double kComes = 4.5, kSpeed = 1.2;  // s, m/s
  std::vector<humanmodel::SkeletonFrame> truth = comingIn(0.0, kComes, 0.1, kSpeed);
  const auto later = comingIn(5.5, kComes, 8.5, kSpeed);
  truth.insert(truth.end(), later.begin(), later.end());
  SimulatedClip clip = simulate(kPlan, truth, {});
  std::size_t done = 0, of = 0;
  tracking::ClipTrackerOptions options;
  options.progress = [&](std::size_t images, std::size_t all) {
    EXPECT_EQ(images, ++done);
    of = all;
  };
  const tracking::ClipTrack track = trackClip(*clip.stream, options);
  EXPECT_EQ(done, of);
  EXPECT_EQ(of, 2 * truth.size());
  EXPECT_GE(expectTracked(clip.truth, track).tracked.within(), kWithin);
  EXPECT_TRUE(track.people[0].stature.known());
}

TEST(ComingIn, LivePersonOfGivenHeightIsAwaited) {
  constexpr double kSpeed = 1.2;  // m/s
  SimulatedClip clip = simulate(kPlan, comingIn(0.0, -0.5 / kSpeed, 3.0 / kSpeed, kSpeed), {});
  tracking::LiveTrackerOptions options;
  options.person.height = 1.75;
  options.person.fit_body = false;
  tracking::LiveTracker tracker({&clip.stream->camera(), 1}, true, options);
  std::vector<humanmodel::SkeletonFrame> frames;
  tracking::DepthFrame frame;
  while (clip.stream->next(frame))
    for (const tracking::LiveTracker::Seen& seen : tracker.see(frame)) frames.push_back(seen.frame);
  const JointErrors errors = compare(frames, clip.truth);
  EXPECT_GE(errors.tracked.within(), kWithin);
  EXPECT_LE(JointErrors::mean(errors.tracked.error), kOfLiveBody);
}

}  // namespace coming_in_test
}  // namespace abstand::testing
