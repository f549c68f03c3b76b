// One robot of the closed loop: its plan, its reaction, and its body in the physics or its position.
#pragma once

#include "app/loop/motion_clock.hpp"
#include "app/session/robot_reaction.hpp"
#include "core/mechanism/inverse_dynamics.hpp"
#include "core/mechanism/joint_limit_watch.hpp"
#include "core/mechanism/mass_matrix.hpp"
#include "core/physics/physics_world.hpp"

namespace abstand::loop {

/// What a robot went through, so far. Of the cycles in which somebody could look.
struct RobotRecord {
  struct Moment {
    PairId pair{0};
    double t{kNaN}, value{kNaN};
  };
  Moment nearest_person;             ///< m, smallest distance of its links from people; NaN: no such pair
  Moment nearest;                    ///< m, of all pairs with its links
  double max_torque{0.0};            ///< N m or N, largest that the reaction asked of a joint
  double max_off_plan{0.0};          ///< rad or m, largest difference of a joint from its plan
  double lost_time{0.0};             ///< s, by which its plan is behind
  double stopped{0.0}, slowed{0.0};  ///< s, in any stop; at less than full speed
};

/// A torque-controlled robot is a body of the physics: gravity, its own inertia and what touches it move it,
/// and its motors give the efforts of hold() and of the reaction. With the law `admittance` it is
/// position-controlled: it goes exactly where plan and offset say, whatever touches it, as fast as its
/// joints' limits allow, and needs no masses; where it has them, its motors' efforts are limited too. Both
/// keep the limits of JointLimits (JointLimiter); what broke them nevertheless, limits() says. Loop thread
/// only; nothing allocates or throws but the constructor.
class ReactingRobot {
 public:
  /// Starts on its plan at `t`, moving as planned. Throws ParseError for a mechanism that the physics cannot
  /// move. Driver, scene and world must outlive it.
  ReactingRobot(session::MechanismDriver& driver, const scene_file::MechanismDescription& description,
                const scene::Scene& scene, const std::vector<bool>& people, physics::PhysicsWorld& world,
                double t);

  /// A person lets it go on, in the next react().
  void reset() { reaction_.reset(); }
  /// Whether the torques of its reaction reach its motors.
  void setTorques(bool on) { reaction_.setTorques(on); }
  /// Puts the links where they are now.
  void place(double t, scene::Scene& scene);
  /// A cycle: its time and how long it lasts, and how old (s) the person least known and the oldest result of
  /// a pair are.
  struct Cycle {
    double t, h, person_age, result_age;
  };
  /// After the scene's step: looks at its pairs, and tells its motors what to do until the next cycle.
  void react(const Cycle& cycle, const scene::Scene& scene);
  /// After the world's step.
  void follow();

  const session::RobotPairs& pairs() const { return reaction_.pairs(); }
  const RobotRecord& record() const { return record_; }
  const safety::StopMachine& stops() const { return reaction_.stops(); }
  /// What position, velocity, acceleration and effort did against the robot's limits, in every cycle.
  const mechanism::JointLimitWatch& limits() const { return limits_; }
  /// N m or N, of the motors in the last cycle: all laws together, within the joints' limits. Of a
  /// position-controlled robot without masses 0.
  std::span<const double> applied() const { return applied_; }
  bool positioned() const { return number_ < 0; }  ///< position-controlled
  int number() const { return number_; }           ///< in the world
  const session::HeldLink* held() const { return reaction_.held(); }
  std::span<const double> q() const { return q_; }
  std::span<const double> qd() const { return qd_; }
  std::span<const double> qdd() const { return qdd_; }        ///< rad/s^2 or m/s^2, over the last cycle
  std::span<const double> torque() const { return torque_; }  ///< of the reaction, before the joint's limit
  std::span<const double> planned() const { return plan_.now().q; }
  double speedScale() const { return scale_; }
  session::MechanismDriver& driver() const { return driver_; }

 private:
  /// Of its links at the present joint values.
  struct Dynamics {
    mechanism::RigidTree tree;
    mechanism::TreeState state;
    mechanism::MassMatrix mass;
  };
  /// Joint values and speeds of the next cycle.
  struct NextState {
    std::vector<double> q, qd;
  };
  /// Of each joint, within a cycle; `bias`: the efforts that gravity and velocity need.
  struct Scratch {
    std::vector<double> acceleration, hold_efforts, bias;
  };

  void look(double t, double h, std::span<const control::ReactionPair> pairs, const scene::Scene& scene);
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
  std::optional<physics::JointLimiter> limiter_;  ///< of a position-controlled robot with masses
  std::vector<double> q_, qd_, qdd_, torque_, applied_;
  NextState next_;                            ///< of a position-controlled robot
  std::vector<double> wanted_, last_wanted_;  ///< the same: where plan and offset say
  Scratch scratch_;
  double t_next_{0.0};  ///< s, of follow()
  double scale_{1.0};
  double h_{0.0};  ///< s, of the last cycle
  bool braked_{false};
  RobotRecord record_;
};

}  // namespace abstand::loop
