// One mechanism that is moved from outside, and its reaction to what is near.
#pragma once

#include "app/serve/state_report.hpp"
#include "app/session/robot_mass.hpp"
#include "app/session/robot_reaction.hpp"
#include "core/mechanism/joint_limit_watch.hpp"

namespace abstand::serve {

/// Joint values in, torques, speed and stops out. Before the first joint values its reaction has not begun:
/// it counts as stopped for stale input. Velocities of the joints are differences of their values over the
/// time stamps of the sender; the first values come from rest. One thread; nothing allocates or throws but
/// the constructor.
class ServedRobot {
 public:
  /// `people`: of each object of the scene, whether it is a person's part. Throws UsageError for a reaction
  /// that does not fit the mechanism. Driver and scene must outlive it.
  ServedRobot(session::MechanismDriver& driver, const scene_file::MechanismDescription& description,
              const scene::Scene& scene, const std::vector<bool>& people,
              const control::ReactionDescription& reaction);

  /// New joint values that came at `t` (s), measured at `stamp` (s on the sender's clock).
  void moveTo(std::span<const double> q, double t, double stamp, scene::Scene& scene);
  /// A person lets it go on, in the next react().
  void reset() { reaction_.reset(); }
  void setTorques(bool on) { reaction_.setTorques(on); }
  /// Puts what it holds where it is now; before the scene's step.
  void placeHeld(double t, scene::Scene& scene);
  /// Marks the links as stale when the joint values are older than `stale` s.
  void grow(double t, double stale, scene::Scene& scene);
  /// After the scene's step. `person_age`: s, of the person least known. `torque`, `offset`: of its own
  /// joints; the latter may be empty.
  void react(double t, double person_age, const scene::Scene& scene, RobotReport& report,
             std::span<double> torque, std::span<double> offset);

  double age(double t) const { return t - last_t_; }  ///< s, infinite before the first joint values
  bool stale() const { return stale_; }
  std::size_t dof() const { return qd_.size(); }
  const safety::StopLog& stops() const { return reaction_.stops().log(); }
  /// What the joint values that came did against the robot's limits of position, and of velocity where two
  /// time stamps of the sender are known.
  const mechanism::JointLimitWatch& limits() const { return limits_; }

 private:
  session::MechanismDriver& driver_;
  session::RobotReaction reaction_;
  session::RobotMass mass_;
  mechanism::JointLimitWatch limits_;
  std::vector<double> qd_;
  double last_t_{-kInfinity}, last_stamp_{-kInfinity}, last_react_{kNaN};
  bool stale_{true}, started_{false};
};

}  // namespace abstand::serve
