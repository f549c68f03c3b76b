// A robots' program run at another pace.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mechanism/motion_file.hpp"

namespace abstand::tune {

/// The recorded motion of a mechanism. Its times are times of the program.
struct ProgramMotion {
  std::string mechanism;
  mechanism::MotionTable motion;
};

/// When a slower or faster robot is where in its program: linear between nodes. All robots of a scene share
/// one, so that they stay in step. Before the program begins, clock and program are the same; behind its end
/// the program stands. Constant after construction.
class ProgramPace {
 public:
  /// s: both lists rise strictly and have the same length, two at least.
  ProgramPace(std::vector<double> program, std::vector<double> clock);
  /// The whole program at `scale` (positive) of its speed.
  static ProgramPace uniform(double begin, double end, double scale);

  double clockAt(double program) const;
  double programAt(double clock) const;
  /// s of the clock, of the whole program.
  double cycleTime() const { return clock_.back() - clock_.front(); }
  std::span<const double> program() const { return program_; }
  std::span<const double> clock() const { return clock_; }

 private:
  std::vector<double> program_, clock_;
};

/// A stretch of the program and the share of its speed that is permitted there.
struct PermittedPace {
  double t0{0.0}, t1{0.0};  ///< s of the program
  double scale{1.0};        ///< positive
};

/// The fastest pace of the program of `motions` that is nowhere above the one permitted there (1 outside of
/// `permitted`, whose stretches follow each other) and changes so that no joint speeds up or slows down by
/// more than `deceleration` (rad/s^2 or m/s^2) through the change: it falls before a slower stretch and rises
/// behind it. Changes of speed that the motions have themselves stay, times the pace. In nodes of kPaceStep
/// where it changes.
ProgramPace permittedProgram(const std::vector<PermittedPace>& permitted,
                             const std::vector<ProgramMotion>& motions, double deceleration);
inline constexpr double kPaceStep = 0.01;  ///< s of the program

/// The same joint path with the times of `pace`: rows where either has one. Its joint values lie on those of
/// `motion`, whose rows are kept exactly.
mechanism::MotionTable retimed(const mechanism::MotionTable& motion, const ProgramPace& pace);

/// s, from the first row of all motions to the last one.
double programBegin(const std::vector<ProgramMotion>& motions);
double programEnd(const std::vector<ProgramMotion>& motions);

}  // namespace abstand::tune
