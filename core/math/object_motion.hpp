// Velocity of an object, estimated from its last poses.
#pragma once

#include <array>

#include "core/math/transform.hpp"

namespace abstand {

/// Rotation vector (rad, world axes) that turns R_from into R_to: its direction is the axis, its length the
/// angle, at most pi.
Vector3d rotationBetween(const Matrix3d& R_WFrom, const Matrix3d& R_WTo);

/// The last kPoses steps between poses. Allocates nothing.
template <int kPoses>
class MotionHistory {
 public:
  void clear() { steps_ = next_ = 0; }
  bool started() const { return started_; }
  void start() {
    clear();
    started_ = true;
  }

  /// Adds a step of `dt` > 0 s: displacement of the centre of mass (m) and rotation vector (rad), world axes.
  void add(double dt, const Vector3d& displacement, const Vector3d& rotation) {
    ring_[static_cast<std::size_t>(next_)] = {dt, displacement, rotation};
    next_ = (next_ + 1) % kSteps;
    steps_ = steps_ < kSteps ? steps_ + 1 : kSteps;
  }

  /// Sum of the steps over the sum of their times, so long steps weigh more; zero without steps.
  Twist mean() const {
    Twist sum;
    double time = 0.0;
    for (int i = 0; i < steps_; ++i) {
      const Step& s = ring_[static_cast<std::size_t>(i)];
      sum.linear += s.displacement;
      sum.angular += s.rotation;
      time += s.dt;
    }
    if (steps_ == 0) return {};
    return {sum.linear / time, sum.angular / time};
  }

  /// Like mean(), but each step has `fade` (0 to 1) times the weight of the next one. 0: the last step alone.
  Twist fadedMean(double fade) const {
    Twist sum;
    double time = 0.0, weight = 1.0;
    for (int age = 0; age < steps_; ++age, weight *= fade) {
      const Step& s = ring_[static_cast<std::size_t>((next_ - 1 - age + kSteps) % kSteps)];
      sum.linear += weight * s.displacement;
      sum.angular += weight * s.rotation;
      time += weight * s.dt;
    }
    if (steps_ == 0) return {};
    return {sum.linear / time, sum.angular / time};
  }

 private:
  static constexpr int kSteps = kPoses - 1;
  struct Step {
    double dt{0.0};
    Vector3d displacement{Vector3d::Zero()}, rotation{Vector3d::Zero()};
  };
  std::array<Step, static_cast<std::size_t>(kSteps)> ring_;
  int steps_{0}, next_{0};
  bool started_{false};
};

}  // namespace abstand
