#include "app/loop/motion_clock.hpp"

namespace abstand::loop {

MotionClock::MotionClock(const mechanism::MotionTable* motion, std::span<const double> q, double start)
    : q_(q.begin(), q.end()), qd_(q.size(), 0.0), qdd_(q.size(), 0.0), full_(q.size(), 0.0), time_(start) {
  if (motion) motion_.emplace(*motion);
  evaluate(1.0);
}

void MotionClock::advance(double dt, double scale) {
  time_ += scale * dt;
  evaluate(scale);
}

void MotionClock::evaluate(double scale) {
  if (!motion_) return;
  motion_->at(time_, q_, full_, qdd_);
  for (std::size_t i = 0; i < q_.size(); ++i) {
    qd_[i] = scale * full_[i];
    qdd_[i] *= scale * scale;
  }
}

}  // namespace abstand::loop
