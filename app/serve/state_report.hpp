// State of `abstand serve` after a cycle, as plain values. See docs/serve.md.
#pragma once

#include <string>
#include <vector>

#include "app/serve/packet.hpp"
#include "core/safety/stop_machine.hpp"

namespace abstand::serve {

/// Reliability of a distance. kNone: its input is stale, and the distance is -infinity: nothing is proven,
/// and no comparison treats it as safe.
enum class Trust : std::uint32_t { kNone, kInferred, kFresh };

struct RobotReport {
  double speed_scale{0.0};
  double input_age{kInfinity};  ///< s, of its joint values
  double since{0.0};            ///< s on the server clock, start of the stop state
  safety::StopState state{safety::StopState::kProtectiveStop};
  bool has_reason{true};
  safety::StopReason reason{safety::StopReason::kStaleInput};
  safety::ResetRefusal refusal{safety::ResetRefusal::kNone};  ///< for a reset in this cycle
};

/// The nearest pair of a person and a robot (no other pair of them is nearer than distance - bound), or one
/// of the nearest pairs of all.
struct PairReport {
  int a{-1}, b{-1};  ///< objects of the scene; -1: none
  Trust trust{Trust::kNone};
  double distance{-kInfinity};  ///< m, signed
  double bound{kInfinity};      ///< m; the true distance is never below distance - bound
  Vector3d witness_a{Vector3d::Zero()}, witness_b{Vector3d::Zero()};  ///< m, world: nearest points
};

/// Sizes are constant.
struct StateReport {
  std::uint64_t time_us{0};  ///< server clock, 0 at its start
  double cycle_us{0.0};      ///< of the previous cycle
  std::uint32_t bad{0}, late{0}, lost{0}, duplicates{0};
  bool torques_on{true};            ///< if false, all torques are 0 by command
  std::uint32_t not_checked{0};     ///< number of pairs in groups that are not running, or in none
  std::vector<double> person_age;   ///< s, for each person the age of the oldest part; infinite: never seen
  std::vector<RobotReport> robots;  ///< of each mechanism
  std::vector<double> torque;       ///< N m or N, of all joints, to be added to the robot's commands
  /// rad or m, of all joints, to be added to the commanded positions: from the law `admittance`, 0 for
  /// mechanisms without it; empty if none has it.
  std::vector<double> offset;
  std::vector<Wrench> links;           ///< contact wrench on each link about its centre of mass, world axes
  std::vector<PairReport> separation;  ///< of person p and mechanism m at p * mechanisms + m
  std::vector<PairReport> nearest;     ///< of all pairs, in order of known distance
};

/// Names for text output, in the order of the report.
struct StateNames {
  std::vector<std::string> links, objects;
};

}  // namespace abstand::serve
