#include "core/control/reaction.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::control {
namespace {

// Causes raised by watch(), the laws and the limits, one for each reason.
constexpr std::size_t kOwnCauses = 9;

double product(std::span<const double> row, std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * x[i];
  return sum;
}

}  // namespace

void scaleGains(ReactionDescription& reaction, double factor) {
  if (reaction.torque) reaction.torque->gain *= factor;
  if (reaction.repulsion) reaction.repulsion->force *= factor;
}

Reaction::Reaction(const ReactionDescription& description, int dof, std::size_t max_pairs,
                   std::vector<mechanism::DofLimits> limits)
    : description_(description), limits_(std::move(limits)), stops_(description.stop), mass_(dof) {
  if (limits_.empty()) limits_.resize(static_cast<std::size_t>(dof));
  ABSTAND_CHECK(limits_.size() == static_cast<std::size_t>(dof));
  bounds_.resize(limits_.size());
  TorqueLimitOptions efforts;
  efforts.limit.clear();
  for (const mechanism::DofLimits& l : limits_) efforts.limit.push_back(l.effort);
  if (dof > 0) efforts_.emplace(efforts, dof);
  if (description.torque) limit_.emplace(*description.torque, dof);
  if (description.repulsion) repulsion_.emplace(*description.repulsion);
  if (description.proxy) description.proxy->validate();
  if (description.admittance) admittance_.emplace(*description.admittance, dof);
  if (description.speed) speed_.emplace(*description.speed);
  config::requireNumbers(description.watch);
  WatchOptions::eachList(description.watch, [&](const char* name, const config::JointNumbers& numbers,
                                                const config::NumberRule& rule) {
    joint_speed_ = config::forJoints(WatchOptions::kName, name, numbers, dof, rule);
  });
  torque_.assign(static_cast<std::size_t>(dof), 0.0);
  approaches_.reserve(max_pairs);
  approach_pairs_.reserve(max_pairs);
  causes_.reserve(kMaxCauses + kOwnCauses);
}

void Reaction::exchangeLaws(Reaction& next) noexcept {
  ABSTAND_CHECK(next.dof() == dof());
  std::swap(description_, next.description_);
  std::swap(limit_, next.limit_);
  std::swap(repulsion_, next.repulsion_);
  std::swap(joint_speed_, next.joint_speed_);
  if (admittance_ && next.admittance_) admittance_->swapOptions(*next.admittance_);
  if (proxy_ && description_.proxy) proxy_->setOptions(*description_.proxy);
  if (speed_ && next.speed_)
    speed_->setOptions(next.speed_->options());
  else
    std::swap(speed_, next.speed_);
  stops_.setOptions(description_.stop);  // valid: the constructor of `next` has checked them
}

void Reaction::hold(const geometry::EnclosingSphere& sphere_O, const Transform& X_WO) {
  if (!description_.proxy) return;
  proxy_.emplace(*description_.proxy, sphere_O);
  proxy_->reset(X_WO);
}

void Reaction::requestStop(safety::StopReason reason, double value, double limit, int pair,
                           int joint) noexcept {
  causes_.push_back({reason, value, limit, pair, joint});
}

void Reaction::watch(const ReactionInput& input) noexcept {
  const WatchOptions& w = description_.watch;
  if (!(input.input_age <= w.input_age))
    requestStop(safety::StopReason::kStaleInput, input.input_age, w.input_age, -1, -1);
  if (!(input.person_age <= w.person_age))
    requestStop(safety::StopReason::kLostPerson, input.person_age, w.person_age, -1, -1);
  // The nearest pair below the limit; an unknown distance counts as the nearest.
  const ReactionPair* nearest = nullptr;
  for (const ReactionPair& p : input.pairs)
    if (!(p.certified() >= w.distance) && (!nearest || !(p.certified() >= nearest->certified())))
      nearest = &p;
  if (nearest)
    requestStop(safety::StopReason::kDistance, nearest->certified(), w.distance, nearest->pair, -1);
  int joint = -1;
  double largest_share = 1.0;
  for (std::size_t i = 0; i < joint_speed_.size(); ++i) {
    const double share = std::abs(input.qd[i]) / joint_speed_[i];
    if (share <= largest_share) continue;
    joint = static_cast<int>(i);
    if (!std::isnan(share)) largest_share = share;
  }
  if (joint >= 0)
    requestStop(safety::StopReason::kJointSpeed, std::abs(input.qd[static_cast<std::size_t>(joint)]),
                joint_speed_[static_cast<std::size_t>(joint)], -1, joint);
}

void Reaction::addRepulsion(const ReactionInput& input, const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept {
  const bool by_matrix = mass_.factorize(M);
  if (!by_matrix) ++without_mass_;
  const RepulsionOptions& o = repulsion_->options();
  safety::StopCause worst;
  double largest_excess = 0.0;
  for (const ReactionPair& p : input.pairs) {
    if (p.distance >= o.range) continue;
    ABSTAND_CHECK(p.row.size() == torque_.size());
    const double squared = product(p.row, p.row);
    if (!(squared > 0.0)) continue;  // no joint influences the distance
    const double own = product(p.row, input.qd);
    const double rate = own + (std::isnan(p.other_rate) ? 0.0 : p.other_rate);
    const RepulsionResult r =
        repulsion_->update(p.distance, rate, own, by_matrix ? mass_.mass(p.row) : o.mass);
    for (std::size_t i = 0; i < torque_.size(); ++i) torque_[i] += p.row[i] * r.force;
    const double excess = r.kinetic - o.stop_share * r.available;
    if (!r.stop || excess <= largest_excess) continue;
    largest_excess = excess;
    worst = {safety::StopReason::kEnergy, r.kinetic, o.stop_share * r.available, p.pair, -1};
  }
  if (largest_excess > 0.0) causes_.push_back(worst);
}

double Reaction::scaleSpeed(const ReactionInput& input) noexcept {
  if (!speed_) return 1.0;
  const std::span<const double> planned = input.planned.empty() ? input.qd : input.planned;
  approaches_.clear();
  approach_pairs_.clear();
  for (const ReactionPair& p : input.pairs) {
    if (!p.person) continue;
    ABSTAND_CHECK(p.row.size() == torque_.size());
    approaches_.push_back({p.certified(), p.spread - product(p.row, planned), -p.other_rate});
    approach_pairs_.push_back(p.pair);
  }
  const double scale = speed_->update(approaches_, input.dt);
  if (speed_->slowest() < 0) return scale;
  const int pair = approach_pairs_[static_cast<std::size_t>(speed_->slowest())];
  if (scale > 0.0) {
    requestStop(safety::StopReason::kSeparation, speed_->planned(), speed_->permitted(), pair, -1);
  } else {
    // Even at standstill the distance is too small, or barely sufficient: the protective separation distance
    // is violated.
    const Approach& a = approaches_[static_cast<std::size_t>(speed_->slowest())];
    const auto& o = speed_->options().separation;
    requestStop(
        safety::StopReason::kDistance, a.distance,
        safety::protectiveDistance(o, speed_->options().min_scale * a.robot, a.person, a.distance).sum(),
        pair, -1);
  }
  return scale;
}

/// Largest share of the planned speed at which no joint exceeds its velocity limit.
double Reaction::withinSpeedLimits(const ReactionInput& input, double scale) const noexcept {
  for (std::size_t i = 0; i < input.planned.size(); ++i) {
    const double speed = std::abs(input.planned[i]);
    if (scale * speed > limits_[i].velocity) scale = limits_[i].velocity / speed;
  }
  return scale;
}

/// The admittance's next velocity v' gives qd' = qd + v' - v, which must be within the joint's limits.
void Reaction::yield(const ReactionInput& input) noexcept {
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    bounds_[i] = {};
    const double v = admittance_->velocity()[i], qd = input.qd[i];
    const double q = input.q.empty() ? kNaN : input.q[i];
    if (!std::isfinite(qd) || !(input.dt > 0.0)) {
      bounds_[i] = {-limits_[i].velocity, limits_[i].velocity};
      continue;
    }
    mechanism::DofLimits known = limits_[i];
    if (!std::isfinite(q)) known.lower = -kInfinity, known.upper = kInfinity;
    const mechanism::VelocityBounds next =
        mechanism::velocityBounds(known, std::isfinite(q) ? q : 0.0, qd, known.acceleration, input.dt);
    // The admittance velocity itself is limited by the joint's velocity limit.
    const double max_speed = limits_[i].velocity;
    bounds_[i] = {std::clamp(v + next.lower - qd, -max_speed, max_speed),
                  std::clamp(v + next.upper - qd, -max_speed, max_speed)};
  }
  admittance_->update(torque_, input.dt, bounds_);
}

ReactionOutput Reaction::update(const ReactionInput& input,
                                const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept {
  ABSTAND_CHECK(input.qd.size() == torque_.size() && input.pairs.size() <= approaches_.capacity() &&
                input.causes.size() <= kMaxCauses);
  causes_.assign(input.causes.begin(), input.causes.end());
  watch(input);

  // Torques.
  std::fill(torque_.begin(), torque_.end(), 0.0);
  if (limit_ && !input.efforts.empty())
    for (std::size_t i = 0; i < torque_.size(); ++i) torque_[i] = limit_->gain() * input.efforts[i];
  if (repulsion_) addRepulsion(input, M);
  if (limit_) {
    const int joint = limit_->cut(torque_);
    if (joint >= 0) requestStop(safety::StopReason::kTorque, kNaN, limit_->limit(joint), -1, joint);
  }
  if (!torques_on_) std::fill(torque_.begin(), torque_.end(), 0.0);
  if (efforts_) {
    const int joint = efforts_->cut(torque_);
    if (joint >= 0) requestStop(safety::StopReason::kTorque, kNaN, efforts_->limit(joint), -1, joint);
  }
  if (proxy_ && input.held) proxy_->update(input.held->X_WH, input.held->constraints);

  // Speed and stops.
  double scale = withinSpeedLimits(input, scaleSpeed(input));
  double fastest = 0.0;
  for (const double v : input.qd)
    if (!(std::abs(v) <= fastest)) fastest = std::isnan(v) ? kInfinity : std::abs(v);
  const safety::StopState state = stops_.update(input.t, causes_, fastest, input.reset);
  for (const safety::StopCause& cause : causes_)
    if (cause.reason != safety::StopReason::kSeparation &&
        description_.stop.policy.of(cause.reason) == safety::StopResponse::kSlow)
      scale = std::min(scale, description_.stop.slow_to);
  if (state == safety::StopState::kEmergencyStop) brakes_ = true;
  if (stops_.moving()) {
    brakes_ = false;
  } else {
    scale = 0.0;
    if (speed_) speed_->stop();
  }
  if (brakes_) std::fill(torque_.begin(), torque_.end(), 0.0);

  if (admittance_ && brakes_) admittance_->hold();
  if (admittance_ && !brakes_) yield(input);
  ReactionOutput out;
  out.torque = torque_;
  if (admittance_) {
    out.velocity = admittance_->velocity();
    out.offset = admittance_->offset();
  }
  out.speed_scale = scale;
  out.state = state;
  out.brakes = brakes_;
  return out;
}

}  // namespace abstand::control
