// One mechanism moved by a client, and its reaction.
#pragma once

#include "app/serve/state_report.hpp"
#include "app/session/robot_mass.hpp"
#include "app/session/robot_reaction.hpp"
#include "core/mechanism/joint_limit_watch.hpp"

namespace abstand::serve {

/// Input: joint values; output: torques, speed scale and stops. Before the first joint values its reaction
/// counts as stopped for stale input. Joint velocities are differences of values over the sender's time
/// stamps; the first values count as at rest. One thread; only the constructor allocates or throws.
class ServedRobot {
 public:
  /// `people`: for each object of the scene, whether it is part of a person. Throws UsageError for a reaction
  /// that does not fit the mechanism. Driver and scene must outlive this object.
  ServedRobot(session::MechanismDriver& driver, const scene_file::MechanismDescription& description,
              const scene::Scene& scene, const std::vector<bool>& people,
              const control::ReactionDescription& reaction);

  /// Sets joint values that arrived at `t` (s), measured at `stamp` (s on the sender's clock).
  void moveTo(std::span<const double> q, double t, double stamp, scene::Scene& scene);
  /// The user releases it in the next react().
  void reset() { reaction_.reset(); }
  void setTorques(bool on) { reaction_.setTorques(on); }
  /// Sets the held link's pose; call before the scene's step.
  void placeHeld(double t, scene::Scene& scene);
  /// Marks the links as stale if the joint values are older than `stale` s.
  void grow(double t, double stale, scene::Scene& scene);
  /// Call after the scene's step. `person_age`: s, oldest pose of a person. `torque`, `offset`: of its own
  /// joints; the latter may be empty.
  void react(double t, double person_age, const scene::Scene& scene, RobotReport& report,
             std::span<double> torque, std::span<double> offset);

  double age(double t) const { return t - last_t_; }  ///< s, infinite before the first joint values
  bool stale() const { return stale_; }
  std::size_t dof() const { return qd_.size(); }
  const safety::StopLog& stops() const { return reaction_.stops().log(); }
  /// Of the present stop state; before the first joint values: stale input.
  safety::StopCause cause() const {
    return started_ ? reaction_.stops().cause() : safety::StopCause{safety::StopReason::kStaleInput};
  }
  /// Violations of the robot's position limits by received joint values, and of velocity limits if two time
  /// stamps of the sender are known.
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
