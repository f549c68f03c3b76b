// Violations of robot limits by a run or by its plan.
#pragma once

#include <string>
#include <vector>

#include "app/loop/closed_loop.hpp"
#include "app/run/reservations.hpp"

namespace abstand::run {

/// Worst violation of one kind of limit by one joint. SI.
struct JointLimitReport {
  std::string mechanism, joint;
  mechanism::LimitBreach worst;
  bool slides{false};  ///< prismatic joint: m, N; otherwise rad, N m
  /// Caused by the scene's `q` or `motion`; otherwise by a robot of the closed loop.
  bool planned{false};
};

/// Reports of one mechanism with the violations `breaches`.
std::vector<JointLimitReport> reportsOf(const std::string& name, const mechanism::Mechanism& mechanism,
                                        const std::vector<mechanism::LimitBreach>& breaches, bool planned);

/// Reports of all mechanisms of the session, from `start` to `end` (s): violations by their plans and, for
/// reacting robots, in every cycle of `loop` (null: none).
std::vector<JointLimitReport> jointLimitsOf(const session::Session& session, const loop::ClosedLoop* loop,
                                            double start, double end);

/// Reservations: the judged motion is impossible for the real robot, because its plan violates a limit or it
/// was pushed beyond one. Fails with --strict.
std::vector<Reservation> reservationsOf(const std::vector<JointLimitReport>& reports);

/// One sentence without a line break.
std::string describe(const JointLimitReport& report);

}  // namespace abstand::run
