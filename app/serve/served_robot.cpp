#include "app/serve/served_robot.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::serve {
namespace {

// s between two time stamps of a sender. Otherwise its clock was set or stands still, and ours is used.
constexpr double kMinStep = 1e-5, kMaxStep = 10.0;

}  // namespace

ServedRobot::ServedRobot(session::MechanismDriver& driver,
                         const scene_file::MechanismDescription& description, const scene::Scene& scene,
                         const std::vector<bool>& people, const control::ReactionDescription& reaction)
    : driver_(driver),
      reaction_(driver, description, reaction, scene, people),
      mass_(driver.mechanism()),
      limits_(mechanism::dofLimits(driver.mechanism())) {
  qd_.assign(static_cast<std::size_t>(driver.dof()), 0.0);
}

void ServedRobot::moveTo(std::span<const double> q, double t, double stamp, scene::Scene& scene) {
  const double by_stamp = stamp - last_stamp_;
  const bool timed = by_stamp >= kMinStep && by_stamp <= kMaxStep;
  const double dt = timed ? by_stamp : std::max(t - last_t_, kMinStep);
  for (std::size_t i = 0; i < qd_.size(); ++i) qd_[i] = started_ ? (q[i] - driver_.q()[i]) / dt : 0.0;
  // Arrival times do not determine a robot's speed.
  limits_.check(t, q, timed && started_ && !stale_ ? std::span<const double>(qd_) : std::span<const double>(),
                {}, {});
  driver_.moveTo(q, t, scene);
  last_t_ = t;
  last_stamp_ = stamp;
  stale_ = false;
  started_ = true;
}

void ServedRobot::placeHeld(double t, scene::Scene& scene) {
  if (started_) reaction_.placeHeld(t, scene);
}

void ServedRobot::grow(double t, double stale, scene::Scene& scene) {
  if (stale_ || age(t) <= stale) return;
  driver_.markStale(t, scene);
  stale_ = true;
}

void ServedRobot::react(double t, double person_age, const scene::Scene& scene, RobotReport& report,
                        std::span<double> torque, std::span<double> offset) {
  report.input_age = age(t);
  if (!started_) return;
  // A robot with stale joint values may be moving.
  if (stale_) std::fill(qd_.begin(), qd_.end(), kNaN);
  const double dt = std::isnan(last_react_) ? 0.0 : t - last_react_;
  reaction_.gather({t, dt, driver_.q(), qd_, {}, age(t), person_age}, scene);
  last_react_ = t;
  const control::ReactionOutput out = reaction_.update(mass_.at(driver_.q()));
  for (std::size_t i = 0; i < torque.size(); ++i)
    torque[i] = stale_ || !std::isfinite(out.torque[i]) ? 0.0 : out.torque[i];
  if (!out.offset.empty() && !offset.empty()) std::copy(out.offset.begin(), out.offset.end(), offset.begin());
  const safety::StopMachine& stops = reaction_.stops();
  report.speed_scale = out.speed_scale;
  report.state = out.state;
  report.since = stops.since();
  report.has_reason = out.state != safety::StopState::kRunning;
  report.reason = stops.cause().reason;
  report.refusal = stops.refusal();
}

}  // namespace abstand::serve
