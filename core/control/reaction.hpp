// One robot's reaction: all its laws, its speed and its stops, once a cycle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/control/effective_mass.hpp"
#include "core/control/reaction_description.hpp"

namespace abstand::control {

/// What a robot knows of one pair with one of its links (or two).
struct ReactionPair {
  int pair{-1};                ///< index in the scene, for the log
  double distance{kInfinity};  ///< m, lower bound: PairResult::distance - bound
  /// d(distance)/dq, size dof (addDistanceRow); may be empty where no law looks: beyond the range of the
  /// repulsion, and, for the speed, of a pair without a person.
  std::span<const double> row;
  /// m/s, rate of the distance that the other body's motion causes: negative when it comes nearer. NaN: not
  /// known, taken as standing by the repulsion and as 1.6 or 2.0 m/s by the speed.
  double other_rate{0.0};
  /// m/s, by how much another point of the link may come nearer faster than the nearest one at the planned
  /// speed, by the link's turning (fastestAlong); 0: only the nearest points count.
  double spread{0.0};
  bool person{false};  ///< the other body is a person's part: the speed is scaled by this pair
};

/// The held object of the god-object method.
struct HeldObject {
  Transform X_WH{Transform::Identity()};           ///< where the robot would put it
  std::span<const ContactConstraint> constraints;  ///< at Reaction::proxy()->pose()
};

/// What is known in one cycle. All spans have the size dof, or are empty where it says so.
struct ReactionInput {
  double t{0.0}, dt{0.0};           ///< s, of this cycle and since the last one
  std::span<const double> q{};      ///< rad or m, measured; empty: position limits are not looked at
  std::span<const double> qd;       ///< rad/s or m/s, measured
  std::span<const double> planned;  ///< qd at scale 1; empty: qd
  std::span<const double> efforts;  ///< N m or N, J^T of the contact forces; empty: none
  std::span<const ReactionPair> pairs;
  const HeldObject* held{nullptr};
  double input_age{0.0}, person_age{0.0};  ///< s; not finite: lost. A scene without people says 0
  /// What is known outside: lost link, broken bounds on speed, the user. At most Reaction::kMaxCauses.
  std::span<const safety::StopCause> causes;
  bool reset{false};  ///< the user lets it go on, in this cycle
};

/// What the robot is to do. Spans point into the Reaction and hold until its next update.
struct ReactionOutput {
  std::span<const double> torque;    ///< N m or N, to be added to the robot's own
  std::span<const double> velocity;  ///< rad/s or m/s, to be added; empty without an admittance
  std::span<const double> offset;    ///< rad or m, to be added to the commanded positions; likewise
  double speed_scale{1.0};           ///< 0 to 1, of the planned speed
  safety::StopState state{safety::StopState::kRunning};
  bool brakes{false};  ///< to be engaged: an emergency stop, until it is reset
};

/// The pipeline, in this order:
///   1. torque = gain * efforts (law `torque`) + J^T of the potentials (`repulsion`), all cut at the
///      limits of the law, then at the joints' effort limits, scaled together so that the direction stays.
///   2. velocity, offset = admittance of that torque, such that the joints keep their limits.
///   3. speed_scale = of the pairs with people (`speed`), such that the plan keeps the velocity limits.
///   4. state = of all causes; while it stops, the scale is 0. A protective stop goes on yielding to people
///      and things; an emergency stop engages the brakes and takes all torques away, until it is reset.
/// The wrench of the held object's spring is proxy()->wrench(); the caller maps it to the joints and gives it
/// in as efforts. One thread. update() allocates nothing, throws nothing.
class Reaction {
 public:
  static constexpr std::size_t kMaxCauses = 32;

  /// Throws UsageError for options that do not fit `dof` joints. `limits`: of the robot, one a dof; empty:
  /// none are known.
  Reaction(const ReactionDescription& description, int dof, std::size_t max_pairs,
           std::vector<mechanism::DofLimits> limits = {});

  /// @param M  mass matrix, dof x dof, at the present posture; 0 x 0 where it is not known
  ReactionOutput update(const ReactionInput& input, const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept;

  /// Off: its torques are 0 from the next update on, and an admittance sees none; stops and speed are as
  /// ever.
  void setTorques(bool on) { torques_on_ = on; }

  const safety::StopMachine& stops() const { return stops_; }
  const SpeedScale* speed() const { return speed_ ? &*speed_ : nullptr; }
  GodObject* proxy() { return proxy_ ? &*proxy_ : nullptr; }
  /// Made when a law `proxy` is there; before, proxy() is null.
  void hold(const geometry::EnclosingSphere& sphere_O, const Transform& X_WO);
  int dof() const { return static_cast<int>(torque_.size()); }
  /// Cycles in which the mass matrix was not known or not usable, and the repulsion took its own mass.
  long withoutMass() const { return without_mass_; }

 private:
  void ask(safety::StopReason reason, double value, double limit, int pair, int joint) noexcept;
  void watch(const ReactionInput& input) noexcept;
  void addRepulsion(const ReactionInput& input, const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept;
  double scaleSpeed(const ReactionInput& input) noexcept;
  double withinSpeedLimits(const ReactionInput& input, double scale) const noexcept;
  void yield(const ReactionInput& input) noexcept;

  ReactionDescription description_;
  std::vector<mechanism::DofLimits> limits_;
  std::vector<mechanism::VelocityBounds> bounds_;
  std::optional<TorqueLimit> limit_;    ///< the law
  std::optional<TorqueLimit> efforts_;  ///< of the joints; null: no limit is known
  std::optional<Repulsion> repulsion_;
  std::optional<GodObject> proxy_;
  std::optional<Admittance> admittance_;
  std::optional<SpeedScale> speed_;
  safety::StopMachine stops_;
  EffectiveMass mass_;
  config::JointNumbers joint_speed_;
  std::vector<double> torque_;
  std::vector<Approach> approaches_;
  std::vector<int> approach_pairs_;
  std::vector<safety::StopCause> causes_;
  bool brakes_{false};
  bool torques_on_{true};
  long without_mass_{0};
};

}  // namespace abstand::control
