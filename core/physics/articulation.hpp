// A mechanism in a physics world: its state, what pushes it, and how a step moves it.
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

/// What solves a mechanism's equations of motion. Both take the same steps, of second order and reversible,
/// so that energy does not drift (leapfrog: qd stands half a step before q):
///
///     qd' = qd + h M(q)^-1 (efforts - C(q, u) u - g(q) + sum of J^T w), u = (qd + qd') / 2;   q' = q + h qd'
enum class MechanismSolver {
  kJointed,  ///< ODE: one body a joint in maximal coordinates, joints and stops as constraints. Default
  kReduced   ///< our own forward dynamics in joint coordinates: for many joints, or links without mass
};

struct MechanismOptions {
  MechanismSolver solver{MechanismSolver::kJointed};
  bool limits{true};  ///< joints stop at JointLimits::lower and upper
  /// Motors keep positions, velocities and accelerations within JointLimits, as far as their efforts allow
  /// (JointLimiter). Without `limits` nothing is kept. Efforts never leave their limits.
  bool motors_keep_limits{true};
  bool gravity_compensation{false};  ///< motors carry g(q) besides what they are told
  std::vector<double> damping{};     ///< N m s/rad or N s/m, one a dof, 0 or more; empty: none
};

/// Loop thread only. All quantities in world axes.
class Articulation {
 public:
  /// Throws ParseError (with the mechanism's name as file) for a mechanism that cannot be simulated: a frame
  /// whose mass is no body's; UsageError for options that do not fit it.
  Articulation(const mechanism::Mechanism& mechanism, const Transform& X_WB, const MechanismOptions& options,
               const Vector3d& gravity_W);
  virtual ~Articulation() = default;
  Articulation(const Articulation&) = delete;
  Articulation& operator=(const Articulation&) = delete;

  int dof() const { return tree_.dof; }
  std::span<const double> q() const { return q_; }
  std::span<const double> qd() const { return qd_; }
  /// Puts the mechanism there, moving so. Sizes: dof.
  void setState(std::span<const double> q, std::span<const double> qd);

  /// Effort (N m, N) of the dof's motor, until it is set again. Beyond the joint's limit it is cut.
  void setEffort(int dof, double effort) { efforts_[static_cast<std::size_t>(dof)] = effort; }
  /// The dof's motor keeps the velocity (rad/s, m/s) as well as `max_effort` (N m, N; 0: off) allows; the
  /// effort of setEffort() acts besides. While it is on it takes the place of the damping, and of the care
  /// for the limits.
  void setMotor(int dof, double velocity, double max_effort);

  /// N m or N, what the motors gave in the last step under setEffort(), within their limits; without what
  /// setMotor() asks for.
  std::span<const double> appliedEfforts() const { return drive_; }

  /// A wrench that acts during the next step on the body of frame `frame`; torque about `p_W`.
  void addWrench(int frame, const Wrench& w_W, const Vector3d& p_W);

  bool hasFrame(int frame) const {
    return frame >= 0 && static_cast<std::size_t>(frame) < tree_.frames.size();
  }
  Transform pose(int frame) const { return mechanism::poseOfFrame(tree_, state_, frame); }
  /// m/s, rad/s: of the point of the frame's body that is at `p_W`.
  Twist velocityAt(int frame, const Vector3d& p_W) const;
  /// mobility() of the frame's body (effective_mass.hpp); 0 for what is fixed to the base.
  double mobilityOf(int frame, const Vector3d& p_W, const Wrench& w_W);

  /// Kinetic plus potential energy, J.
  mechanism::MechanicalEnergy energy();

  /// Before and after the ODE world's step of `h` seconds. No allocation after the first step.
  virtual void begin(double h) = 0;
  virtual void end(double h) = 0;

 protected:
  struct Motor {
    double velocity{0.0};
    double most{0.0};  ///< effort; 0: off
  };
  /// Limits and what else is said about one joint, that is one body of the tree.
  struct JointSide {
    double lower, upper;  ///< of the joint's value
    double share;         ///< |scale| over the sum of |scale| of its dof: its share of the motor's effort
    double damping;       ///< of this joint alone
  };

  /// Motor efforts of this step, cut to the limits and gravity compensation included, and the middle rates u,
  /// as if there were no stops and motors to keep a velocity.
  void drive(double h);
  /// After qd_ has been set: moves q_ by it, forgets the wrenches.
  void advance(double h);
  /// After q_ and qd_ have been set: poses and velocities.
  void settle();
  double value(std::size_t body) const;

  mechanism::RigidTree tree_;  ///< its base is the world
  Vector3d gravity_W_;
  bool compensated_;
  std::vector<double> most_;  ///< effort limit a dof
  std::vector<JointSide> joints_;
  std::vector<double> q_, qd_, efforts_;
  std::vector<Motor> motors_;
  std::vector<Wrench> external_;  ///< a body; about the world's origin
  std::vector<double> drive_;     ///< a dof
  std::vector<double> middle_;    ///< u, a dof
  mechanism::TreeState state_;    ///< of q_ and qd_
  mechanism::MassMatrix mass_;

 private:
  bool factorMass();
  bool factored_{false};
  std::optional<JointLimiter> limiter_;
  std::vector<double> work_, command_, next_rates_;
  std::vector<bool> motored_;  ///< a dof: its motor is on
  mechanism::TreeState spare_;
};

/// Beyond its stop, a joint returns at this share of what it overshot a step (ODE's own default), so with at
/// most this share of the speed that it came with, and never faster than kStopSpeed (rad/s, m/s), so that a
/// mechanism that is put down far outside its limits is not thrown.
inline constexpr double kStopReturn = 0.2;
inline constexpr double kStopSpeed = 0.5;

/// rad/s, m/s: no joint moves faster, whatever pushes it, so that numbers stay numbers.
inline constexpr double kMaxRate = 1e4;

std::unique_ptr<Articulation> makeJointed(dxWorld* world, const mechanism::Mechanism& mechanism,
                                          const Transform& X_WB, const MechanismOptions& options,
                                          const Vector3d& gravity_W);
std::unique_ptr<Articulation> makeReduced(const mechanism::Mechanism& mechanism, const Transform& X_WB,
                                          const MechanismOptions& options, const Vector3d& gravity_W);

}  // namespace abstand::physics
