// People, postures, things and cameras that are drawn at random: a check that no constant was chosen with.
#pragma once

#include <functional>

#include "tests/tracking/tracker/simulated_clip.hpp"

namespace abstand::testing {

struct RandomScene {
  std::string name;    ///< "random_7_12": seed and number
  std::string remark;  ///< what was drawn: "posed 1.63 m, at 3.1 m, 0.9 m high, from 140"
  /// Of the first camera (0), or of another one that looks at the same person from elsewhere; the truth is
  /// the same.
  std::function<SimulatedClip(std::size_t camera)> make;
};

/// `count` clips of 4 to 8 s; the same on every machine for the same seed. Half of them are parts of
/// captures, half are written postures with other hands left and right. The camera is 1 to 5 m away and 0.5
/// to 2.8 m high, on any side, so that people can be partly outside of the image. Captures that are missing
/// on a machine are left out.
std::vector<RandomScene> randomScenes(std::uint64_t seed, int count);

}  // namespace abstand::testing
