// A ball that flies at a wall: distances in closed form.
#pragma once

#include <algorithm>
#include <string>

namespace abstand::testing {

inline const char* const kBallAndWall = R"(abstand: 1
defaults: {voxel: 0.005, point: 0.005}
objects:
  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-0.1, 0, 0]}}
  - {name: ball, shape: {sphere: {radius: 0.05}}}
)";

/// The ball flies at the wall at 1 m/s and stops `stop` before it; 101 frames.
inline std::string ballPoses(double stop) {
  std::string csv = "t";
  for (const char* c : {"r00", "r01", "r02", "tx", "r10", "r11", "r12", "ty", "r20", "r21", "r22", "tz"})
    csv += std::string(",ball.") + c;
  csv += "\n";
  for (int i = 0; i <= 100; ++i) {
    const double t = i * 0.01;
    csv +=
        std::to_string(t) + ",1,0,0," + std::to_string(std::max(1.0 - t, stop) + 0.05) + ",0,1,0,0,0,0,1,0\n";
  }
  return csv;
}

}  // namespace abstand::testing
