// Common part of both solvers.
#include "core/physics/articulation.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/mechanism/link_inertia.hpp"

namespace abstand::physics {
namespace {

// Fixed-point rounds of drive(), and the largest relative change of a rate at which they end.
constexpr int kMaxRounds = 10;
constexpr double kConverged = 1e-13;

void judge(const mechanism::Mechanism& mechanism, const MechanismOptions& options) {
  for (const auto& f : mechanism.frames) {
    const std::string fault = mechanism::inertiaFault(f.inertia);
    if (!fault.empty()) throw ParseError({mechanism.name}, "frame '" + f.name + "': " + fault);
  }
  if (!options.damping.empty() && options.damping.size() != static_cast<std::size_t>(mechanism.dof))
    throw UsageError("damping: found " + std::to_string(options.damping.size()) + " values, expected " +
                     std::to_string(mechanism.dof));
  for (const double d : options.damping)
    if (!(d >= 0.0) || !std::isfinite(d))
      throw UsageError("damping: found " + std::to_string(d) + ", expected a finite number, 0 or more");
}

}  // namespace

Articulation::Articulation(const mechanism::Mechanism& mechanism, const Transform& X_WB,
                           const MechanismOptions& options, const Vector3d& gravity_W)
    : gravity_W_(gravity_W), compensated_(options.gravity_compensation) {
  judge(mechanism, options);
  tree_ = mechanism::makeRigidTree(mechanism);
  mechanism::moveBase(tree_, X_WB);
  const auto dof = static_cast<std::size_t>(tree_.dof);
  max_effort_.assign(dof, kInfinity);
  std::vector<double> sizes(dof, 0.0), squares(dof, 0.0);
  for (const mechanism::TreeBody& b : tree_.bodies) {
    const auto k = static_cast<std::size_t>(b.dof);
    const double effort = mechanism.frames[static_cast<std::size_t>(b.frame)].limits.effort;
    // The effort of a dof is its joint's times the scale; of mimic joints the first one has the motor.
    if (sizes[k] == 0.0 && effort < kInfinity) max_effort_[k] = std::abs(b.scale) * effort;
    sizes[k] += std::abs(b.scale);
    squares[k] += b.scale * b.scale;
  }
  for (const mechanism::TreeBody& b : tree_.bodies) {
    const auto k = static_cast<std::size_t>(b.dof);
    const mechanism::JointLimits& limits = mechanism.frames[static_cast<std::size_t>(b.frame)].limits;
    JointSide side{-kInfinity, kInfinity, 0.0, 0.0};
    if (options.limits) {
      side.lower = limits.lower;
      side.upper = limits.upper;
    }
    if (sizes[k] > 0.0) {
      side.share = 1.0 / sizes[k];
      side.damping = options.damping.empty() ? 0.0 : options.damping[k] / squares[k];
    }
    joints_.push_back(side);
  }
  q_.assign(dof, 0.0);
  qd_.assign(dof, 0.0);
  efforts_.assign(dof, 0.0);
  motors_.assign(dof, {});
  drive_.assign(dof, 0.0);
  middle_.assign(dof, 0.0);
  work_.assign(dof, 0.0);
  command_.assign(dof, 0.0);
  next_rates_.assign(dof, 0.0);
  motored_.assign(dof, false);
  if (options.limits && options.motors_keep_limits) {
    std::vector<mechanism::DofLimits> limits = mechanism::dofLimits(mechanism);
    for (std::size_t k = 0; k < dof; ++k) limits[k].effort = max_effort_[k];
    limiter_.emplace(std::move(limits));
  }
  external_.assign(tree_.bodies.size(), {});
  settle();
}

void Articulation::setState(std::span<const double> q, std::span<const double> qd) {
  ABSTAND_CHECK(q.size() == q_.size() && qd.size() == qd_.size());
  std::copy(q.begin(), q.end(), q_.begin());
  std::copy(qd.begin(), qd.end(), qd_.begin());
  settle();
}

void Articulation::setMotor(int dof, double velocity, double max_effort) {
  motors_[static_cast<std::size_t>(dof)] = {velocity, max_effort};
  motored_[static_cast<std::size_t>(dof)] = max_effort > 0.0;
}

void Articulation::addWrench(int frame, const Wrench& w_W, const Vector3d& p_W) {
  ABSTAND_CHECK(hasFrame(frame));
  const int body = tree_.frames[static_cast<std::size_t>(frame)].body;
  if (body >= 0) external_[static_cast<std::size_t>(body)] += mechanism::aboutOrigin(w_W, p_W);
}

Twist Articulation::velocityAt(int frame, const Vector3d& p_W) const {
  ABSTAND_CHECK(hasFrame(frame));
  const int body = tree_.frames[static_cast<std::size_t>(frame)].body;
  if (body < 0) return {};
  const mechanism::TreeBodyState& s = state_.bodies[static_cast<std::size_t>(body)];
  return {s.velocity + s.omega.cross(p_W - s.p_B), s.omega};
}

double Articulation::mobilityOf(int frame, const Vector3d& p_W, const Wrench& w_W) {
  ABSTAND_CHECK(hasFrame(frame));
  const int body = tree_.frames[static_cast<std::size_t>(frame)].body;
  if (body < 0) return 0.0;
  if (!factorMass()) return 0.0;
  return mechanism::mobility({tree_, state_, mass_}, body, p_W, w_W, work_);
}

mechanism::MechanicalEnergy Articulation::energy() {
  return mechanism::mechanicalEnergy(tree_, q_, qd_, gravity_W_, spare_);
}

bool Articulation::factorMass() {
  if (factored_) return true;
  mechanism::massMatrix(tree_, state_, mass_);
  factored_ = mechanism::factor(mass_) < 0;
  return factored_;
}

void Articulation::drive(double h) {
  if (compensated_)
    mechanism::gravityEfforts(tree_, q_, gravity_W_, spare_, drive_);
  else
    std::fill(drive_.begin(), drive_.end(), 0.0);
  for (std::size_t k = 0; k < drive_.size(); ++k)
    drive_[k] = command_[k] = std::clamp(drive_[k] + efforts_[k], -max_effort_[k], max_effort_[k]);

  // The error shrinks in each round by the rotation in one step, so a few rounds are enough.
  middle_ = qd_;
  if (!factorMass()) return;
  for (int round = 0; round < kMaxRounds; ++round) {
    mechanism::inverseDynamics(tree_, {q_, middle_, {}}, {gravity_W_, external_}, spare_, work_);
    for (std::size_t k = 0; k < work_.size(); ++k) next_rates_[k] = h * (command_[k] - work_[k]);
    mechanism::solveMass(mass_, next_rates_);
    for (std::size_t k = 0; k < work_.size(); ++k) next_rates_[k] += qd_[k];
    if (limiter_) limiter_->limit(mass_, {h, q_, qd_, work_, command_, next_rates_, drive_}, motored_);
    double change = 0.0, size = 0.0;
    for (std::size_t k = 0; k < work_.size(); ++k) {
      const double next = std::clamp(0.5 * (qd_[k] + next_rates_[k]), -kMaxRate, kMaxRate);
      change = std::max(change, std::abs(next - middle_[k]));
      size = std::max(size, std::abs(next));
      middle_[k] = next;
    }
    if (change <= kConverged * size) return;
  }
}

void Articulation::advance(double h) {
  for (std::size_t k = 0; k < q_.size(); ++k) {
    qd_[k] = std::clamp(qd_[k], -kMaxRate, kMaxRate);
    q_[k] += h * qd_[k];
  }
  std::fill(external_.begin(), external_.end(), Wrench{});
  settle();
}

void Articulation::settle() {
  mechanism::placeBodies(tree_, q_, state_);
  mechanism::moveBodies(tree_, qd_, state_);
  factored_ = false;
}

double Articulation::value(std::size_t body) const {
  const mechanism::TreeBody& b = tree_.bodies[body];
  return b.offset + b.scale * q_[static_cast<std::size_t>(b.dof)];
}

}  // namespace abstand::physics
