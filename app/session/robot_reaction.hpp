// One robot's reaction to the pairs of a scene, whoever moves the robot.
#pragma once

#include "app/session/braking_watch.hpp"
#include "app/session/held_link.hpp"

namespace abstand::session {

/// The laws of a robot (control::Reaction) with all that they need of a running scene: its pairs, the contact
/// efforts on its joints, the object it holds, and whether it could still stop. The closed loop and `serve`
/// differ in what moves the robot and in what they do with the output. One thread; nothing allocates or
/// throws but the constructor.
class RobotReaction {
 public:
  /// `people`: partsOfPeople(). Throws UsageError for a reaction that does not fit the mechanism. Driver and
  /// scene must outlive it.
  RobotReaction(MechanismDriver& driver, const scene_file::MechanismDescription& description,
                const control::ReactionDescription& reaction, const scene::Scene& scene,
                const std::vector<bool>& people);

  /// The robot in one cycle; all spans of size dof.
  struct Cycle {
    double t, dt;                     ///< s, of this cycle and since the last one
    std::span<const double> q, qd;    ///< rad or m, and per second, measured; NaN: not known
    std::span<const double> planned;  ///< qd at full speed; empty: qd
    double input_age, person_age;     ///< s, of the joint values or results, and of the person least known
  };

  /// A user lets it go on, in the next update().
  void reset() { reset_ = true; }
  /// Whether its torques reach the motors.
  void setTorques(bool on) { reaction_.setTorques(on); }
  /// Puts what it holds where it is now; after the driver placed the links, before the scene's step.
  void placeHeld(double t, scene::Scene& scene);
  /// After the scene's step: looks at the robot's pairs, in the order of pairs().own().
  std::span<const control::ReactionPair> gather(const Cycle& cycle, const scene::Scene& scene);
  /// Then what the robot is to do. `M`: mass matrix at the present posture; 0 x 0 where it is not known.
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
  std::optional<safety::StopCause> cause_;  ///< what input_ refers to
  std::vector<double> efforts_;
  bool reset_{false};
};

}  // namespace abstand::session
