// Which limits of its robots a run broke, or was planned to break.
#pragma once

#include <string>
#include <vector>

#include "app/loop/closed_loop.hpp"
#include "app/run/reservations.hpp"

namespace abstand::run {

/// The worst of one joint against one kind of limit. SI.
struct JointLimitReport {
  std::string mechanism, joint;
  mechanism::LimitBreach worst;
  bool slides{false};  ///< the joint is prismatic: m, N; else rad, N m
  /// The scene's `q` or `motion` asks for it; without, a robot of the closed loop did it.
  bool planned{false};
};

/// Of one mechanism; `breaches` are its own.
std::vector<JointLimitReport> reportsOf(const std::string& name, const mechanism::Mechanism& mechanism,
                                        const std::vector<mechanism::LimitBreach>& breaches, bool planned);

/// Of all mechanisms of the session, from `start` to `end` (s): what their plans ask for, and, of those that
/// react, what they did in every cycle of `loop` (null: none reacts).
std::vector<JointLimitReport> jointLimitsOf(const session::Session& session, const loop::ClosedLoop* loop,
                                            double start, double end);

/// The robot that was judged does not exist: it is planned to be where, or as fast as, the real one cannot
/// be, or it was pushed beyond its limits. With --strict that fails.
std::vector<Reservation> reservationsOf(const std::vector<JointLimitReport>& reports);

/// One sentence for people, without a line break.
std::string describe(const JointLimitReport& report);

}  // namespace abstand::run
