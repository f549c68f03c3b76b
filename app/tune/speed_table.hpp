// The highest speed of each stretch of a robot's program.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// A stretch of the program, the same times in every recording.
struct SpeedSegment {
  double t0{0.0}, t1{0.0};  ///< s
  double speed_scale{1.0};  ///< of the recorded speed; 0: the robot would have had to stand
  /// What limits it; none at 1.
  struct Limit {
    std::size_t recording{0};  ///< index
    double t{0.0};
    std::string part;
  };
  std::optional<Limit> limited_by;
};

/// Of each stretch of `length` s the smallest speed scale of all recordings and parts (PartSeparation):
/// robots that are slowed down evenly over a stretch keep the protective distance to people who do as
/// recorded, at the same places of the program. That slower robots meet people elsewhere is not in it.
std::vector<SpeedSegment> speedTable(const std::vector<TunedRecording>& recordings, double length);

/// s, of the program with these speeds; infinite where it has to stand.
double cycleTime(const std::vector<SpeedSegment>& segments);

}  // namespace abstand::tune
