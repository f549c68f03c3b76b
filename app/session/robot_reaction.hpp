// Reaction of one robot in a running scene.
#pragma once

#include "app/session/braking_watch.hpp"
#include "app/session/held_link.hpp"

namespace abstand::session {

/// The laws of a robot (control::Reaction) with their inputs from the scene: its pairs, contact efforts on
/// its joints, the held object, and the braking check. Shared by the closed loop and `serve`, which move the
/// robot and use the output differently. One thread; only the constructor allocates or throws.
class RobotReaction {
 public:
  /// `people`: partsOfPeople(). Throws UsageError for a reaction that does not fit the mechanism. Driver and
  /// scene must outlive this object.
  RobotReaction(MechanismDriver& driver, const scene_file::MechanismDescription& description,
                const control::ReactionDescription& reaction, const scene::Scene& scene,
                const std::vector<bool>& people);

  /// Input of one cycle; all spans have size dof.
  struct Cycle {
    double t, dt;                     ///< s, of this cycle and since the last one
    std::span<const double> q, qd;    ///< rad or m, and per second, measured; NaN: unknown
    std::span<const double> planned;  ///< qd at full speed; empty: qd
    double input_age, person_age;     ///< s, of the joint values or results, and of the person with the
                                      ///< oldest pose
  };

  /// Exchanges the laws with those of `next`, made for this robot; stops and all other state stay
  /// (control::Reaction::exchangeLaws). Between two cycles; allocates if the law `braking` changes.
  void exchangeLaws(control::Reaction& next, const scene::Scene& scene);
  /// A force that somebody applies to a link.
  struct PointForce {
    int frame;          ///< of the mechanism; not below 0
    Vector3d p_W, f_W;  ///< m, N
  };
  /// For the next gather() only: its joint efforts J^T f are added to those of the contacts.
  void push(const PointForce& force) noexcept { push_ = force; }
  /// The user releases the robot in the next update().
  void reset() { reset_ = true; }
  /// Whether its torques are sent to the motors.
  void setTorques(bool on) { reaction_.setTorques(on); }
  /// Sets the held link's pose; call after the driver has placed the links, before the scene's step.
  void placeHeld(double t, scene::Scene& scene);
  /// Call after the scene's step: evaluates the robot's pairs, in the order of pairs().own().
  std::span<const control::ReactionPair> gather(const Cycle& cycle, const scene::Scene& scene);
  /// Call after gather(): commands to the robot. `M`: mass matrix in the current posture; 0 x 0 if unknown.
  control::ReactionOutput update(const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept;

  const RobotPairs& pairs() const { return pairs_; }
  const HeldLink* held() const { return held_ ? &*held_ : nullptr; }
  const safety::StopMachine& stops() const { return reaction_.stops(); }

 private:
  MechanismDriver& driver_;
  control::Reaction reaction_;
  RobotPairs pairs_;
  std::optional<BrakingWatch> braking_;
  std::optional<HeldLink> held_;
  control::ReactionInput input_;
  std::optional<safety::StopCause> cause_;  ///< referenced by input_
  std::vector<double> efforts_;
  std::optional<PointForce> push_;
  bool reset_{false};
};

}  // namespace abstand::session
