// Somebody who comes into the image from the side.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/support/paths.hpp"
#include "tests/tracking/tracker/simulated_clip.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::testing {

/// Joints (m, world) at 30 Hz from `start` to `end` (s): somebody who reaches out towards +x and moves along
/// -y at `speed` (m/s) from outside of the image of ClipPlan's camera to the origin, from `comes` (s) on.
inline std::vector<humanmodel::SkeletonFrame> comingIn(double start, double comes, double end, double speed) {
  using enum humanmodel::Joint;
  constexpr double kOutside = 3.0;  // m; the image ends at 1.5
  const tracking::Recording recording = tracking::openRecording(projectFile("data/scenes/hug_reach.bvh"));
  std::vector<humanmodel::SkeletonFrame> frames;
  for (double t = start; t < end; t += 1.0 / 30.0) {
    humanmodel::SkeletonFrame frame = recording.at(std::fmod(t, recording.frames.back().t));
    const Vector3d hips = frame[kPelvis], left = frame[kHipLeft] - frame[kHipRight];
    const Eigen::AngleAxisd turn(std::atan2(left.x(), left.y()), Vector3d::UnitZ());
    const Vector3d place(0.0, kOutside - speed * std::clamp(t - comes, 0.0, kOutside / speed), hips.z());
    for (Vector3d& p : frame.p) p = place + turn * (p - hips);
    frame.t = t;
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace abstand::testing
