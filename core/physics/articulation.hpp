// A mechanism in a physics world: state, applied forces, time stepping.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/mechanism/effective_mass.hpp"
#include "core/mechanism/forward_dynamics.hpp"
#include "core/physics/joint_limiter.hpp"

struct dxWorld;  // ODE's

namespace abstand::physics {

/// Solver of a mechanism's equations of motion. Both use the same scheme, of second order and
/// time-reversible, so that energy does not drift (leapfrog: qd is half a step behind q):
///
///     qd' = qd + h M(q)^-1 (efforts - C(q, u) u - g(q) + sum of J^T w), u = (qd + qd') / 2;   q' = q + h qd'
enum class MechanismSolver {
  kJointed,  ///< ODE: one body for each joint in maximal coordinates, joints and stops as constraints.
             ///< Default
  kReduced   ///< own forward dynamics in joint coordinates: for many joints, or links without mass
};

struct MechanismOptions {
  MechanismSolver solver{MechanismSolver::kJointed};
  bool limits{true};  ///< joints stop at JointLimits::lower and upper
  /// Motors keep positions, velocities and accelerations within JointLimits, as far as their effort limits
  /// allow (JointLimiter). No effect without `limits`. Efforts are always limited.
  bool motors_keep_limits{true};
  bool gravity_compensation{false};  ///< motors add g(q) to the commanded efforts
  std::vector<double> damping{};     ///< N m s/rad or N s/m, one for each dof, >= 0; empty: none
};

/// A mechanism that moves under forces. Loop thread only. All quantities in world axes.
class Articulation {
 public:
  /// Throws ParseError (with the mechanism's name as file) for a mechanism that cannot be simulated, because
  /// the mass of a frame is invalid; UsageError for options that do not fit it.
  Articulation(const mechanism::Mechanism& mechanism, const Transform& X_WB, const MechanismOptions& options,
               const Vector3d& gravity_W);
  virtual ~Articulation() = default;
  Articulation(const Articulation&) = delete;
  Articulation& operator=(const Articulation&) = delete;

  int dof() const { return tree_.dof; }
  std::span<const double> q() const { return q_; }
  std::span<const double> qd() const { return qd_; }
  /// Sets positions and velocities; size dof.
  void setState(std::span<const double> q, std::span<const double> qd);

  /// Sets the effort (N m, N) of a dof's motor until it is set again; clipped to the joint's limit.
  void setEffort(int dof, double effort) { efforts_[static_cast<std::size_t>(dof)] = effort; }
  /// The dof's motor tracks a velocity (rad/s, m/s) with at most `max_effort` (N m, N; 0: off), in addition
  /// to the effort of setEffort(). While it is on, damping and JointLimiter do not apply to the dof.
  void setMotor(int dof, double velocity, double max_effort);

  /// Efforts (N m or N) of the motors in the last step due to setEffort(), after limits; without those of
  /// setMotor().
  std::span<const double> appliedEfforts() const { return drive_; }

  /// Adds a wrench for the next step on the body of frame `frame`; torque about `p_W`.
  void addWrench(int frame, const Wrench& w_W, const Vector3d& p_W);

  bool hasFrame(int frame) const {
    return frame >= 0 && static_cast<std::size_t>(frame) < tree_.frames.size();
  }
  Transform pose(int frame) const { return mechanism::poseOfFrame(tree_, state_, frame); }
  /// Velocity (m/s, rad/s) of the point of the frame's body that is at `p_W`.
  Twist velocityAt(int frame, const Vector3d& p_W) const;
  /// mobility() of the frame's body (effective_mass.hpp); 0 if fixed to the base.
  double mobilityOf(int frame, const Vector3d& p_W, const Wrench& w_W);

  /// Kinetic plus potential energy, J.
  mechanism::MechanicalEnergy energy();

  /// Called before and after the ODE world's step of `h` seconds. No allocation after the first step.
  virtual void begin(double h) = 0;
  virtual void end(double h) = 0;

 protected:
  struct Motor {
    double velocity{0.0};
    double max_effort{0.0};  ///< effort limit; 0: off
  };
  /// Limits and damping of one joint, that is of one body of the tree.
  struct JointSide {
    double lower, upper;  ///< of the joint's value
    double share;         ///< |scale| over the sum of |scale| of its dof: share of the motor's effort
    double damping;       ///< of this joint alone
  };

  /// Computes the motor efforts of this step, with limits and gravity compensation, and the middle rates u,
  /// ignoring stops and velocity motors.
  void drive(double h);
  /// After qd_ has been updated: integrates q_ and clears the wrenches.
  void advance(double h);
  /// After q_ and qd_ have been updated: computes poses and velocities.
  void settle();
  double value(std::size_t body) const;

  mechanism::RigidTree tree_;  ///< its base is the world
  Vector3d gravity_W_;
  bool compensated_;
  std::vector<double> max_effort_;  ///< effort limit of each dof
  std::vector<JointSide> joints_;
  std::vector<double> q_, qd_, efforts_;
  std::vector<Motor> motors_;
  std::vector<Wrench> external_;  ///< for each body; about the world's origin
  std::vector<double> drive_;     ///< for each dof
  std::vector<double> middle_;    ///< u, for each dof
  mechanism::TreeState state_;    ///< of q_ and qd_
  mechanism::MassMatrix mass_;

 private:
  bool factorMass();
  bool factored_{false};
  std::optional<JointLimiter> limiter_;
  std::vector<double> work_, command_, next_rates_;
  std::vector<bool> motored_;  ///< for each dof: its motor is on
  mechanism::TreeState spare_;
};

/// Share of the overshoot beyond a stop that is corrected in each step (ODE's default), so that a joint
/// returns with at most this share of its impact speed. Limited to kStopSpeed (rad/s, m/s), so that a
/// mechanism placed far outside of its limits is not thrown.
inline constexpr double kStopReturn = 0.2;
inline constexpr double kStopSpeed = 0.5;

/// rad/s, m/s: limit of all joint rates; keeps values finite.
inline constexpr double kMaxRate = 1e4;

std::unique_ptr<Articulation> makeJointed(dxWorld* world, const mechanism::Mechanism& mechanism,
                                          const Transform& X_WB, const MechanismOptions& options,
                                          const Vector3d& gravity_W);
std::unique_ptr<Articulation> makeReduced(const mechanism::Mechanism& mechanism, const Transform& X_WB,
                                          const MechanismOptions& options, const Vector3d& gravity_W);

}  // namespace abstand::physics
