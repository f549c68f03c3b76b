// Reaction of one robot: all its control laws, speed scale and stops, updated once in each cycle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/control/effective_mass.hpp"
#include "core/control/reaction_description.hpp"

namespace abstand::control {

/// Input of one pair with one (or two) of the robot's links.
struct ReactionPair {
  int pair{-1};                ///< index in the scene, for the log
  double distance{kInfinity};  ///< m, lower bound at the shown poses: PairResult::distance - bound
  /// m, by how much the bodies may be nearer because of their pose uncertainty (directedUncertainty).
  double uncertainty{0.0};
  /// d(distance)/dq, size dof (addDistanceRow); may be empty if no law uses it: beyond the range of the
  /// repulsion and, for the speed, for a pair without a person.
  std::span<const double> row;
  /// m/s, rate of the distance caused by the other body's motion: negative when approaching. NaN: unknown;
  /// the repulsion assumes 0, the speed law 1.6 or 2.0 m/s.
  double other_rate{0.0};
  /// m/s, additional approach speed of other points of the link relative to the nearest one at the planned
  /// speed, due to the link's rotation (fastestAlong); 0: only the nearest points count.
  double spread{0.0};
  bool person{false};  ///< the other body is part of a person: the pair limits the speed

  /// m, lower bound of the true distance; NaN: unknown. Stops and the speed law use it. The repulsion acts on
  /// the bodies as shown, as the contact forces do.
  double certified() const { return distance - uncertainty; }
};

/// Held object of the god-object method.
struct HeldObject {
  Transform X_WH{Transform::Identity()};           ///< pose at which the robot would put it
  std::span<const ContactConstraint> constraints;  ///< at Reaction::proxy()->pose()
};

/// Input of one cycle. All spans have size dof, or are empty where stated.
struct ReactionInput {
  double t{0.0}, dt{0.0};           ///< s, of this cycle and since the last one
  std::span<const double> q{};      ///< rad or m, measured; empty: position limits are not checked
  std::span<const double> qd;       ///< rad/s or m/s, measured
  std::span<const double> planned;  ///< qd at scale 1; empty: qd
  std::span<const double> efforts;  ///< N m or N, J^T of the contact forces; empty: none
  std::span<const ReactionPair> pairs;
  const HeldObject* held{nullptr};
  double input_age{0.0}, person_age{0.0};  ///< s; not finite: lost. 0 in a scene without people
  /// External causes: lost link, exceeded speed bounds, the user. At most Reaction::kMaxCauses.
  std::span<const safety::StopCause> causes;
  bool reset{false};  ///< the user releases the robot in this cycle
};

/// Commands to the robot. Spans point into the Reaction and are valid until its next update.
struct ReactionOutput {
  std::span<const double> torque;    ///< N m or N, to be added to the robot's own
  std::span<const double> velocity;  ///< rad/s or m/s, to be added; empty without an admittance
  std::span<const double> offset;    ///< rad or m, to be added to the commanded positions; likewise
  double speed_scale{1.0};           ///< 0 to 1, of the planned speed
  safety::StopState state{safety::StopState::kRunning};
  bool brakes{false};  ///< engage the brakes: an emergency stop, until reset
};

/// Pipeline, in this order:
///   1. torque = gain * efforts (law `torque`) + J^T of the potentials (`repulsion`), limited by the law's
///      limits, then by the joints' effort limits, scaled together to keep the direction.
///   2. velocity, offset = admittance of that torque, within the joint limits.
///   3. speed_scale = from the pairs with people (`speed`), within the velocity limits of the plan.
///   4. state = from all causes; 0 speed scale while stopped. In a protective stop the robot still yields to
///      people and things; an emergency stop engages the brakes and sets all torques to 0, until reset.
/// The wrench of the held object's spring is proxy()->wrench(); the caller maps it to the joints and passes
/// it as efforts. One thread. update() does not allocate or throw.
class Reaction {
 public:
  static constexpr std::size_t kMaxCauses = 32;

  /// Throws UsageError for options that do not fit `dof` joints. `limits`: one for each dof; empty: unknown.
  Reaction(const ReactionDescription& description, int dof, std::size_t max_pairs,
           std::vector<mechanism::DofLimits> limits = {});

  /// @param M  mass matrix, dof x dof, in the current posture; 0 x 0 if unknown
  ReactionOutput update(const ReactionInput& input, const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept;

  /// Exchanges laws and numbers with `next`, made for the same robot. The state stays: stops (one that is
  /// active ends only by a reset), log, brakes, speed scale, velocity and offset of the admittance, held
  /// object. Admittance and proxy are only exchanged if both have them. `next` is of no use afterwards but to
  /// be destroyed, on any thread. Does not allocate.
  void exchangeLaws(Reaction& next) noexcept;
  const ReactionDescription& description() const { return description_; }

  /// Off: torques are 0 from the next update on, and the admittance gets none; stops and speed are not
  /// affected.
  void setTorques(bool on) { torques_on_ = on; }

  const safety::StopMachine& stops() const { return stops_; }
  const SpeedScale* speed() const { return speed_ ? &*speed_ : nullptr; }
  GodObject* proxy() { return proxy_ ? &*proxy_ : nullptr; }
  /// Creates the proxy of a held object, if there is a law `proxy`; before, proxy() is null.
  void hold(const geometry::EnclosingSphere& sphere_O, const Transform& X_WO);
  int dof() const { return static_cast<int>(torque_.size()); }
  /// Number of cycles without a usable mass matrix, in which the repulsion used its own mass.
  long withoutMass() const { return without_mass_; }

 private:
  void requestStop(safety::StopReason reason, double value, double limit, int pair, int joint) noexcept;
  void watch(const ReactionInput& input) noexcept;
  void addRepulsion(const ReactionInput& input, const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept;
  double scaleSpeed(const ReactionInput& input) noexcept;
  double withinSpeedLimits(const ReactionInput& input, double scale) const noexcept;
  void yield(const ReactionInput& input) noexcept;

  ReactionDescription description_;
  std::vector<mechanism::DofLimits> limits_;
  std::vector<mechanism::VelocityBounds> bounds_;
  std::optional<TorqueLimit> limit_;    ///< of the law
  std::optional<TorqueLimit> efforts_;  ///< of the joints; null: no limits are known
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
