// People seen exactly from the side: the feet show which way they face.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/math/quantile.hpp"
#include "tests/tracking/tracker/captured_scenes.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {
namespace people_from_the_side_test {

/// rad, about the world's z: from the right to the left hip.
double yawOfHips(const humanmodel::SkeletonFrame& frame) {
  const Vector3d left = frame[humanmodel::Joint::kHipLeft] - frame[humanmodel::Joint::kHipRight];
  return std::atan2(left.y(), left.x());
}

/// rad, median of the images.
double yawError(const ClipTrack& track, const std::vector<humanmodel::SkeletonFrame>& truth) {
  std::map<long, const humanmodel::SkeletonFrame*> at;  // by ms
  for (const humanmodel::SkeletonFrame& frame : truth) at[std::lround(1e3 * frame.t)] = &frame;
  std::vector<double> errors;
  for (const humanmodel::SkeletonFrame& frame : track.people[0].frames)
    if (frame.has(humanmodel::Joint::kHipLeft) && frame.has(humanmodel::Joint::kHipRight))
      errors.push_back(std::abs(
          std::remainder(yawOfHips(frame) - yawOfHips(*at.at(std::lround(1e3 * frame.t))), 2.0 * kPi)));
  return errors.empty() ? kInfinity : nearestQuantile(errors, 0.5);
}

// A trunk seen from the side is as broad when it is turned by 30 degrees and deeper. Before the feet turned
// the pelvis: 27 and 32 degrees; 1 and 9 now, and no more with two other seeds.
TEST(PeopleFromTheSide, FaceAsTheirFeet) {
  constexpr double kYaw = 20.0;  // degrees
  int clips = 0;
  for (const auto& [name, plan, furniture] : testing::scenesFromAllSides()) {
    if ((name != "waving_from_90" && name != "waving_from_270") || !exists(plan.recording)) continue;
    auto clip = testing::simulate(plan);
    const ClipTrack track = trackClip(*clip.stream, {});
    ASSERT_EQ(track.people.size(), 1u) << name;
    EXPECT_LE(yawError(track, clip.truth), unit::deg(kYaw)) << name;
    ++clips;
  }
  if (clips == 0) GTEST_SKIP() << "no capture";
}

}  // namespace people_from_the_side_test
}  // namespace abstand::tracking
