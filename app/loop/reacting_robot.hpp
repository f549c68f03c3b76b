// One robot of the closed loop: plan, reaction, and body in the physics or position control.
#pragma once

#include "app/loop/motion_clock.hpp"
#include "app/session/robot_reaction.hpp"
#include "core/mechanism/inverse_dynamics.hpp"
#include "core/mechanism/joint_limit_watch.hpp"
#include "core/mechanism/mass_matrix.hpp"
#include "core/physics/physics_world.hpp"
#include "core/view/robot_drive.hpp"

namespace abstand::loop {

/// Statistics of a robot so far, over the cycles in which its pairs were known.
struct RobotRecord {
  struct Moment {
    PairId pair{0};
    double t{kNaN}, value{kNaN};
  };
  Moment nearest_person;             ///< m, smallest distance of its links from people; NaN: no such pair
  Moment nearest;                    ///< m, over all pairs with its links
  double max_torque{0.0};            ///< N m or N, largest commanded by the reaction to a joint
  double max_off_plan{0.0};          ///< rad or m, largest deviation of a joint from its plan
  double lost_time{0.0};             ///< s, delay of its plan
  double stopped{0.0}, slowed{0.0};  ///< s, in any stop; below full speed
};

/// A torque-controlled robot is a body of the physics: gravity, its inertia and contacts move it, and its
/// motors apply the efforts of hold() and of the reaction. With the law `admittance` it is
/// position-controlled: it follows plan and offset exactly, regardless of contacts, as fast as its joint
/// limits allow, and needs no masses; if it has them, its motors' efforts are limited too. Both keep
/// JointLimits (JointLimiter); remaining violations are in limits(). Loop thread only; only the constructor
/// allocates or throws.
class ReactingRobot {
 public:
  /// Starts on its plan at `t`, moving as planned. Throws ParseError for a mechanism that the physics cannot
  /// simulate. Driver, scene and world must outlive this object.
  ReactingRobot(session::MechanismDriver& driver, const scene_file::MechanismDescription& description,
                const scene::Scene& scene, const std::vector<bool>& people, physics::PhysicsWorld& world,
                double t);

  /// What the robot of a mechanism permits.
  static view::RobotDrive drive(const session::MechanismDriver& driver,
                                const scene_file::MechanismDescription& description);
  /// See RobotReaction. `next` has an admittance exactly if this robot has one.
  void exchangeLaws(control::Reaction& next, const scene::Scene& scene);
  void push(const session::RobotReaction::PointForce& force) noexcept { reaction_.push(force); }

  /// The user releases it in the next react().
  void reset() { reaction_.reset(); }
  /// Whether the torques of its reaction are sent to its motors.
  void setTorques(bool on) { reaction_.setTorques(on); }
  /// Sets the poses of its links.
  void place(double t, scene::Scene& scene);
  /// A cycle: its time and duration, and the ages (s) of the oldest person's pose and of the oldest result of
  /// a pair.
  struct Cycle {
    double t, h, person_age, result_age;
  };
  /// Call after the scene's step: evaluates its pairs and sets the motor commands until the next cycle.
  void react(const Cycle& cycle, const scene::Scene& scene);
  /// Call after the world's step.
  void follow();

  const session::RobotPairs& pairs() const { return reaction_.pairs(); }
  const RobotRecord& record() const { return record_; }
  const safety::StopMachine& stops() const { return reaction_.stops(); }
  /// Violations of position, velocity, acceleration and effort limits, in every cycle.
  const mechanism::JointLimitWatch& limits() const { return limits_; }
  /// N m or N, motor efforts in the last cycle: all laws together, within the joints' limits. 0 for a
  /// position-controlled robot without masses.
  std::span<const double> applied() const { return applied_; }
  bool positioned() const { return number_ < 0; }  ///< position-controlled
  int number() const { return number_; }           ///< index in the physics world
  const session::HeldLink* held() const { return reaction_.held(); }
  std::span<const double> q() const { return q_; }
  std::span<const double> qd() const { return qd_; }
  std::span<const double> qdd() const { return qdd_; }        ///< rad/s^2 or m/s^2, over the last cycle
  std::span<const double> torque() const { return torque_; }  ///< of the reaction, before the joints' limits
  std::span<const double> planned() const { return plan_.now().q; }
  double speedScale() const { return scale_; }
  session::MechanismDriver& driver() const { return driver_; }

 private:
  /// Dynamics of its links at the current joint values.
  struct Dynamics {
    mechanism::RigidTree tree;
    mechanism::TreeState state;
    mechanism::MassMatrix mass;
  };
  /// Joint values and velocities of the next cycle.
  struct NextState {
    std::vector<double> q, qd;
  };
  /// For each joint, within a cycle; `bias`: efforts needed for gravity and velocity.
  struct Scratch {
    std::vector<double> acceleration, hold_efforts, bias;
  };

  void recordProgress(double t, double h, std::span<const control::ReactionPair> pairs,
                      const scene::Scene& scene);
  void drive(const control::ReactionOutput& out);
  void position(const control::ReactionOutput& out, double h);
  void limitPosition(double h);
  void brake(bool on);

  session::MechanismDriver& driver_;
  physics::PhysicsWorld& world_;
  control::HoldOptions hold_;
  session::RobotReaction reaction_;
  MotionClock plan_;
  Dynamics dynamics_;
  Vector3d gravity_B_;
  int number_{-1};
  mechanism::JointLimitWatch limits_;
  std::optional<physics::JointLimiter> limiter_;  ///< for a position-controlled robot with masses
  std::vector<double> q_, qd_, qdd_, torque_, applied_;
  NextState next_;                            ///< for a position-controlled robot
  std::vector<double> wanted_, last_wanted_;  ///< the same: positions by plan and offset
  Scratch scratch_;
  double t_next_{0.0};  ///< s, for follow()
  double scale_{1.0};
  double h_{0.0};  ///< s, of the last cycle
  bool braked_{false};
  RobotRecord record_;
};

}  // namespace abstand::loop
