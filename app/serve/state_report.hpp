// What `abstand serve` knows after a cycle, as plain values. See docs/serve.md.
#pragma once

#include <string>
#include <vector>

#include "app/serve/packet.hpp"
#include "core/safety/stop_machine.hpp"

namespace abstand::serve {

/// How far a distance may be relied on. With kNone, what it rests on is stale, and distances are -infinity:
/// nothing is proven, and no comparison takes it for safe.
enum class Trust : std::uint32_t { kNone, kInferred, kFresh };

struct RobotReport {
  double speed_scale{0.0};
  double input_age{kInfinity};  ///< s, of its joint values
  double since{0.0};            ///< s on the clock of the server, when the state of stop began
  safety::StopState state{safety::StopState::kProtectiveStop};
  bool has_reason{true};
  safety::StopReason reason{safety::StopReason::kStaleInput};
  safety::ResetRefusal refusal{safety::ResetRefusal::kNone};  ///< of a reset in this cycle
};

/// The nearest pair of a person and a robot (then no pair of them is nearer than distance - bound), or one of
/// the nearest pairs of all.
struct PairReport {
  int a{-1}, b{-1};  ///< objects of the scene; -1: none
  Trust trust{Trust::kNone};
  double distance{-kInfinity};  ///< m, signed
  double bound{kInfinity};      ///< m; the true distance is never below distance - bound
  Vector3d witness_a{Vector3d::Zero()}, witness_b{Vector3d::Zero()};  ///< m, world: the nearest points
};

/// Sizes are fixed at the start.
struct StateReport {
  std::uint64_t time_us{0};  ///< clock of the server, 0 at its start
  double cycle_us{0.0};      ///< of the cycle before this one
  std::uint32_t bad{0}, late{0}, lost{0}, duplicates{0};
  bool torques_on{true};            ///< else all torques are 0, by order
  std::uint32_t not_checked{0};     ///< pairs of groups that do not run, or of none
  std::vector<double> person_age;   ///< s, of each person's least known part; infinite: never seen
  std::vector<RobotReport> robots;  ///< of each mechanism
  std::vector<double> torque;       ///< N m or N, of all joints, to be added to the robot's own
  /// rad or m, of all joints, to be added to the commanded positions: of the law `admittance`, 0 for joints
  /// of mechanisms without it; empty where none has it.
  std::vector<double> offset;
  std::vector<Wrench> links;           ///< contact of each link about its centre of mass, world axes
  std::vector<PairReport> separation;  ///< of person p and mechanism m at p * mechanisms + m
  std::vector<PairReport> nearest;     ///< of all pairs, by rising distance as far as it is known
};

/// Names for texts, in the order of the report.
struct StateNames {
  std::vector<std::string> links, objects;
};

}  // namespace abstand::serve
