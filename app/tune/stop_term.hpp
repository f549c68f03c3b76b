// Which term of the protective distance is the largest one when a margin stops the robot.
#pragma once

#include <optional>

#include "app/tune/margin_events.hpp"

namespace abstand::tune {

/// S_p of the pair that stopped the robot, in the first frame of the stop, from its stored speeds.
struct StopTerm {
  safety::ProtectiveDistance needed;
  double clearance{0.0};  ///< m, certified; -infinity: not seen
  /// The largest term (largestTerm()): the one that would have to shrink most.
  const char* largest{""};
  /// True if the protective distance was violated as well: speed and separation monitoring would have stopped
  /// the robot, too.
  bool violated() const { return needed.sum() > clearance; }
};

/// Empty for a touch between frames, and if the link does not move towards the part: S_p asks for nothing
/// then. `options`: those of the pass (PassOptions::separation).
std::optional<StopTerm> stopTerm(const MarginEvent& event, const safety::SeparationOptions& options);

}  // namespace abstand::tune
