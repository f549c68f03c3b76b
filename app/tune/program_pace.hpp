// A robot program at a different pace.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mechanism/motion_file.hpp"

namespace abstand::tune {

/// Recorded motion of a mechanism; its times are program times.
struct ProgramMotion {
  std::string mechanism;
  mechanism::MotionTable motion;
};

/// Relation of clock and program time of a slower or faster robot: piecewise linear between nodes. All robots
/// of a scene share one, so that they stay synchronised. Before the program begins, both are equal; after its
/// end the program time stays constant. Constant after construction.
class ProgramPace {
 public:
  /// s: both lists increase strictly and have the same length, at least two.
  ProgramPace(std::vector<double> program, std::vector<double> clock);
  /// The whole program at the constant pace `scale` (positive).
  static ProgramPace uniform(double begin, double end, double scale);

  double clockAt(double program) const;
  double programAt(double clock) const;
  /// Clock time (s) of the whole program.
  double cycleTime() const { return clock_.back() - clock_.front(); }
  std::span<const double> program() const { return program_; }
  std::span<const double> clock() const { return clock_; }

 private:
  std::vector<double> program_, clock_;
};

/// A program interval with its permitted pace.
struct PermittedPace {
  double t0{0.0}, t1{0.0};  ///< s, program time
  double scale{1.0};        ///< positive
};

/// The fastest pace of the program of `motions` that nowhere exceeds the permitted one (1 outside of
/// `permitted`, whose intervals are in order) and whose changes accelerate no joint by more than
/// `deceleration` (rad/s^2 or m/s^2): it decreases before a slower interval and increases after it. Speed
/// changes of the motions themselves remain, scaled by the pace. Nodes at steps of kPaceStep where it
/// changes.
ProgramPace permittedProgram(const std::vector<PermittedPace>& permitted,
                             const std::vector<ProgramMotion>& motions, double deceleration);
inline constexpr double kPaceStep = 0.01;  ///< s of the program

/// The same joint path with the times of `pace`: rows where either has one. Rows of `motion` are kept
/// exactly, and other joint values are interpolated between them.
mechanism::MotionTable retimed(const mechanism::MotionTable& motion, const ProgramPace& pace);

/// s, first row of all motions; and their last one.
double programBegin(const std::vector<ProgramMotion>& motions);
double programEnd(const std::vector<ProgramMotion>& motions);

}  // namespace abstand::tune
