#include "app/loop/reacting_robot.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::loop {
namespace {

// With more joints the own forward dynamics is faster than ODE's joints (docs/architecture.md).
constexpr int kMaxJointed = 30;
// N m or N, brake effort if the file has no limit; cannot be overcome on robots of this size.
constexpr double kBrake = 1e5;
// rad or m; a position-controlled joint this near is at its target.
constexpr double kThere = 1e-12;

physics::MechanismSolver solverOf(const mechanism::RigidTree& tree) {
  const bool weightless = std::any_of(tree.bodies.begin(), tree.bodies.end(),
                                      [](const mechanism::TreeBody& body) { return body.mass == 0.0; });
  return tree.dof > kMaxJointed || weightless ? physics::MechanismSolver::kReduced
                                              : physics::MechanismSolver::kJointed;
}

void updateNearest(RobotRecord::Moment& moment, PairId pair, double t, double value) {
  if (!(moment.value <= value)) moment = {pair, t, value};
}

}  // namespace

ReactingRobot::ReactingRobot(session::MechanismDriver& driver,
                             const scene_file::MechanismDescription& description, const scene::Scene& scene,
                             const std::vector<bool>& people, physics::PhysicsWorld& world, double t)
    : driver_(driver),
      world_(world),
      hold_(description.reaction->hold),
      reaction_(driver, description, *description.reaction, scene, people),
      plan_(driver.motion() ? &*driver.motion() : nullptr, driver.home(), t),
      dynamics_{mechanism::makeRigidTree(driver.mechanism()), {}, {}},
      gravity_B_(driver.X_WB().linear().transpose() * mechanism::kGravity),
      limits_(mechanism::dofLimits(driver.mechanism())) {
  const auto n = static_cast<std::size_t>(driver.dof());
  const control::PlannedMotion plan = plan_.now();
  q_.assign(plan.q.begin(), plan.q.end());
  qd_.assign(plan.qd.begin(), plan.qd.end());
  // If the plan is faster than the robot, it starts at the robot's speed.
  for (std::size_t i = 0; i < n; ++i)
    qd_[i] = std::clamp(qd_[i], -limits_.limits()[i].velocity, limits_.limits()[i].velocity);
  for (auto* v : {&qdd_, &torque_, &applied_, &next_.q, &next_.qd, &scratch_.acceleration,
                  &scratch_.hold_efforts, &scratch_.bias})
    v->assign(n, 0.0);
  limits_.check(t, q_, qd_, {}, {});
  if (description.reaction->admittance) {
    wanted_ = last_wanted_ = q_;
    const bool weightless = std::any_of(dynamics_.tree.bodies.begin(), dynamics_.tree.bodies.end(),
                                        [](const mechanism::TreeBody& body) { return body.mass == 0.0; });
    if (!weightless) limiter_.emplace(limits_.limits());
    return;
  }
  physics::MechanismOptions options;
  options.solver = solverOf(dynamics_.tree);
  try {
    number_ = world.addMechanism(driver.mechanism(), driver.X_WB(), options);
  } catch (const ParseError& e) {
    throw ParseError(description.pos, std::string(e.what()) + ", in order to move '" + description.name + "'",
                     "a mechanism with a `reaction` needs masses, or the law `admittance`");
  }
  world.mechanism(number_).setState(q_, qd_);
}

view::RobotDrive ReactingRobot::drive(const session::MechanismDriver& driver,
                                      const scene_file::MechanismDescription& description) {
  view::RobotDrive drive;
  physics::MechanismOptions options;
  options.solver = solverOf(mechanism::makeRigidTree(driver.mechanism()));
  try {
    physics::PhysicsWorld world;
    world.addMechanism(driver.mechanism(), driver.X_WB(), options);
  } catch (const ParseError& e) {
    drive.no_torques = e.what();
  }
  control::ReactionDescription holds;
  holds.proxy.emplace();
  try {
    session::HeldLink::find(description, holds);
  } catch (const UsageError& e) {
    drive.no_proxy = e.what();
  }
  return drive;
}

void ReactingRobot::exchangeLaws(control::Reaction& next, const scene::Scene& scene) {
  hold_ = next.description().hold;
  reaction_.exchangeLaws(next, scene);
}

void ReactingRobot::place(double t, scene::Scene& scene) {
  driver_.moveTo(q_, t, scene);
  reaction_.placeHeld(t, scene);
}

void ReactingRobot::recordProgress(double t, double h, std::span<const control::ReactionPair> pairs,
                                   const scene::Scene& scene) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairId id = reaction_.pairs().own()[i].id;
    if (scene.pairs()[id.index()].paused) continue;  // its result is stale
    const double distance = scene.result(id).distance;
    updateNearest(record_.nearest, id, t, distance);
    if (pairs[i].person) updateNearest(record_.nearest_person, id, t, distance);
  }
  const std::span<const double> planned = plan_.now().q;
  for (std::size_t i = 0; i < q_.size(); ++i)
    record_.max_off_plan = std::max(record_.max_off_plan, std::abs(q_[i] - planned[i]));
  record_.lost_time = t - plan_.time();
  if (!stops().moving()) record_.stopped += h;
  if (scale_ < 1.0) record_.slowed += h;
}

void ReactingRobot::react(const Cycle& cycle, const scene::Scene& scene) {
  const double h = cycle.h;
  h_ = h;
  recordProgress(
      cycle.t, h,
      reaction_.gather({cycle.t, h, q_, qd_, plan_.fullSpeed(), cycle.result_age, cycle.person_age}, scene),
      scene);

  mechanism::placeBodies(dynamics_.tree, q_, dynamics_.state);
  mechanism::massMatrix(dynamics_.tree, dynamics_.state, dynamics_.mass);
  const control::ReactionOutput out = reaction_.update(dynamics_.mass.M);
  std::copy(out.torque.begin(), out.torque.end(), torque_.begin());
  for (const double x : torque_) record_.max_torque = std::max(record_.max_torque, std::abs(x));
  scale_ = out.speed_scale;
  t_next_ = cycle.t + h;
  if (positioned()) {
    plan_.advance(h, scale_);
    position(out, h);
    return;
  }
  drive(out);
  if (const session::HeldLink* held = reaction_.held(); held && held->frame() >= 0)
    world_.applyWrench({number_, held->frame()}, held->wrench(), held->point());
  plan_.advance(h, scale_);
}

void ReactingRobot::drive(const control::ReactionOutput& out) {
  brake(out.brakes);
  if (braked_) return;
  control::hold(hold_, plan_.now(), q_, qd_, scratch_.acceleration);
  mechanism::inverseDynamics(dynamics_.tree, {q_, qd_, scratch_.acceleration}, {gravity_B_, {}},
                             dynamics_.state, scratch_.hold_efforts);
  for (std::size_t i = 0; i < q_.size(); ++i)
    world_.setJointEffort(number_, static_cast<int>(i), scratch_.hold_efforts[i] + torque_[i]);
}

/// Next joint values: those of plan and offset or, if not reachable in one cycle, on the way there, slow
/// enough to stop in time.
void ReactingRobot::position(const control::ReactionOutput& out, double h) {
  const control::PlannedMotion plan = plan_.now();
  std::swap(wanted_, last_wanted_);
  for (std::size_t i = 0; i < q_.size(); ++i) {
    wanted_[i] = out.brakes ? q_[i] : plan.q[i] + out.offset[i];
    if (out.brakes) last_wanted_[i] = q_[i];
    const double behind = last_wanted_[i] - q_[i];
    mechanism::DofLimits reach;
    reach.upper = std::abs(behind);
    const double braking =
        limiter_ ? limiter_->braking(dynamics_.mass, scratch_.bias, i) : limits_.limits()[i].acceleration;
    next_.qd[i] = (wanted_[i] - last_wanted_[i]) / h +
                  std::copysign(mechanism::velocityBounds(reach, 0.0, 0.0, braking, h).upper, behind);
  }
  limitPosition(h);
  for (std::size_t i = 0; i < q_.size(); ++i) {
    next_.q[i] = q_[i] + h * next_.qd[i];
    if (std::abs(next_.q[i] - wanted_[i]) < kThere) next_.q[i] = wanted_[i];
  }
}

void ReactingRobot::limitPosition(double h) {
  const auto& limits = limits_.limits();
  const bool weighed = limiter_ && mechanism::factor(dynamics_.mass) < 0;
  if (!weighed) {
    for (std::size_t i = 0; i < q_.size(); ++i) {
      const mechanism::VelocityBounds b =
          mechanism::velocityBounds(limits[i], q_[i], qd_[i], limits[i].acceleration, h);
      next_.qd[i] = std::clamp(next_.qd[i], b.lower, b.upper);
    }
    return;
  }
  // Required motor efforts, their limits, and the resulting motion.
  for (std::size_t i = 0; i < q_.size(); ++i) scratch_.acceleration[i] = (next_.qd[i] - qd_[i]) / h;
  mechanism::inverseDynamics(dynamics_.tree, {q_, qd_, {}}, {gravity_B_, {}}, dynamics_.state, scratch_.bias);
  mechanism::inverseDynamics(dynamics_.tree, {q_, qd_, scratch_.acceleration}, {gravity_B_, {}},
                             dynamics_.state, scratch_.hold_efforts);
  bool able = true;
  for (std::size_t i = 0; i < q_.size(); ++i) {
    const double most = limits[i].effort;
    able = able && std::abs(scratch_.hold_efforts[i]) <= most;
    scratch_.hold_efforts[i] = std::clamp(scratch_.hold_efforts[i], -most, most);
  }
  if (!able) {
    for (std::size_t i = 0; i < q_.size(); ++i)
      next_.qd[i] = h * (scratch_.hold_efforts[i] - scratch_.bias[i]);
    mechanism::solveMass(dynamics_.mass, next_.qd);
    for (std::size_t i = 0; i < q_.size(); ++i) next_.qd[i] += qd_[i];
  }
  limiter_->limit(dynamics_.mass, {h, q_, qd_, scratch_.bias, scratch_.hold_efforts, next_.qd, applied_});
}

void ReactingRobot::brake(bool on) {
  if (on == braked_) return;
  braked_ = on;
  for (int dof = 0; dof < driver_.dof(); ++dof) {
    double most = 0.0;
    for (const mechanism::MechanismFrame& f : driver_.mechanism().frames)
      if (on && f.dof == dof)
        most = std::isfinite(f.limits.effort) ? std::max(most, f.limits.effort) : kBrake;
    world_.setMotor(number_, dof, 0.0, most);
    if (on) world_.setJointEffort(number_, dof, 0.0);
  }
}

void ReactingRobot::follow() {
  const std::span<const double> q = positioned() ? std::span<const double>(next_.q) : world_.q(number_);
  const std::span<const double> qd = positioned() ? std::span<const double>(next_.qd) : world_.qd(number_);
  for (std::size_t i = 0; i < qd_.size(); ++i) qdd_[i] = h_ > 0.0 ? (qd[i] - qd_[i]) / h_ : 0.0;
  if (!positioned()) {
    const std::span<const double> efforts = world_.mechanism(number_).appliedEfforts();
    std::copy(efforts.begin(), efforts.end(), applied_.begin());
  }
  limits_.check(t_next_, q, qd, qdd_, applied_);
  std::copy(q.begin(), q.end(), q_.begin());
  std::copy(qd.begin(), qd.end(), qd_.begin());
}

}  // namespace abstand::loop
