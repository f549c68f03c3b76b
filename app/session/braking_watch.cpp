#include "app/session/braking_watch.hpp"

#include <algorithm>
#include <cmath>

#include "core/mechanism/dof_limits.hpp"

namespace abstand::session {
namespace {

// Limit of samples for one pair; if they do not decide, its certified bound is used.
constexpr int kMaxSamples = 24;

safety::MotionBounds boundsOf(const scene::Object& part, const control::BrakingLawOptions& o) {
  safety::MotionBounds bounds;
  const geometry::EnclosingSphere& sphere = part.spec.structure->bounding_sphere;
  const double turning =
      part.velocity.angular.norm() * ((sphere.centre - part.spec.structure->com).norm() + sphere.radius);
  bounds.speed = std::max(o.person_speed, part.velocity.linear.norm() + turning);
  bounds.acceleration = o.person_acceleration;
  bounds.position_error = part.pose_uncertainty;
  bounds.velocity_error = turning;
  return bounds;
}

/// Limits decelerations to the joint accelerations in the robot's file.
safety::BrakingOptions withinLimits(safety::BrakingOptions o, const mechanism::Mechanism& mechanism) {
  const std::vector<mechanism::DofLimits> limits = mechanism::dofLimits(mechanism);
  o.deceleration = config::forJoints(safety::BrakingOptions::kName, "deceleration", o.deceleration,
                                     mechanism.dof, safety::BrakingOptions::kDecelerationRule);
  for (std::size_t k = 0; k < limits.size(); ++k)
    o.deceleration[k] = std::min(o.deceleration[k], limits[k].acceleration);
  return o;
}

}  // namespace

BrakingWatch::BrakingWatch(const MechanismDriver& driver, const scene::Scene& scene,
                           std::span<const RobotPairs::Own> own, const control::BrakingLawOptions& options)
    : mechanism_(driver.mechanism()),
      options_(options),
      path_(withinLimits(options.path, driver.mechanism()), driver.dof()) {
  config::requireNumbers(options);
  std::vector<int> number(driver.links().size(), -1);
  for (const RobotPairs::Own& pair : own) {
    if (!pair.person) continue;
    const auto link = static_cast<std::size_t>(pair.link_a >= 0 ? pair.link_a : pair.link_b);
    const MechanismDriver::Link& l = driver.links()[link];
    if (l.frame < 0) continue;  // the base never moves
    if (number[link] < 0) {
      number[link] = static_cast<int>(links_.size());
      links_.emplace_back(driver.mechanism(), path_, l.frame, driver.X_WB(), l.X_FL,
                          scene.object(*l.object).spec.structure->bounding_sphere);
    }
    watched_.push_back({pair.id, number[link], pair.link_a >= 0, {}});
  }
  speeds_.resize(links_.size());
  setSwept();
}

void BrakingWatch::setSwept() {
  swept_.enough = options_.distance;
  swept_.hit = options_.distance;
  swept_.max_samples = kMaxSamples;
}

void BrakingWatch::setOptions(const control::BrakingLawOptions& options) {
  config::requireNumbers(options);
  // In place: links_ refer to it.
  path_ = safety::BrakingPath(withinLimits(options.path, mechanism_), mechanism_.dof);
  options_ = options;
  setSwept();
}

double BrakingWatch::minDistance(Watched& w, const scene::Scene& scene) noexcept {
  const scene::Pair& pair = scene.pairs()[w.id.index()];
  const scene::Object& part = scene.object(w.link_a ? pair.b : pair.a);
  const scene::Object& link = scene.object(w.link_a ? pair.a : pair.b);
  const double duration = path_.stopTime();
  const safety::MotionBounds bounds = boundsOf(part, options_);
  safety::UnknownMotion person(part.X_WB, part.velocity.linear, bounds, duration);
  const double now = pair.result.distance - pair.result.bound - bounds.position_error;
  const double rate = speeds_[static_cast<std::size_t>(w.link)] + person.speed(0.0, duration);
  // In no time nothing moves; avoids 0 * infinity.
  const double far = duration > 0.0 ? now - rate * duration : now;
  if (far >= options_.distance || duration == 0.0) return far;
  const safety::SweptResult swept = safety::sweptPair(
      {*link.spec.structure, links_[static_cast<std::size_t>(w.link)]}, {*part.spec.structure, person},
      duration, swept_, safety::SweptContext{w.memory, scratch_.scratch, scratch_.result});
  queries_ += swept.samples;
  return swept.lower;
}

std::optional<safety::StopCause> BrakingWatch::check(const scene::Scene& scene, std::span<const double> q,
                                                     std::span<const double> qd) noexcept {
  queries_ = 0;
  if (watched_.empty()) return std::nullopt;
  std::optional<safety::StopCause> worst;
  if (!path_.start(q, qd))
    return safety::StopCause{safety::StopReason::kBraking, -kInfinity, options_.distance, -1, -1};
  for (std::size_t i = 0; i < links_.size(); ++i) speeds_[i] = links_[i].speed(0.0, path_.stopTime());
  for (Watched& w : watched_) {
    const double lower = minDistance(w, scene);
    if (lower >= options_.distance || (worst && lower >= worst->value)) continue;
    worst = safety::StopCause{safety::StopReason::kBraking, lower, options_.distance,
                              static_cast<int>(w.id.index()), -1};
  }
  return worst;
}

}  // namespace abstand::session
