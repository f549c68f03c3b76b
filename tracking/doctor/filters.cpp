#include "tracking/doctor/filters.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr double kBodyCutoff = 6.0;   // Hz
constexpr double kSpeedCutoff = 1.0;  // Hz, as in the paper

double lowPassShare(double cutoff, double dt) { return 1.0 / (1.0 + 1.0 / (2.0 * kPi * cutoff * dt)); }

/// Runs one filter over every gap-free stretch of a joint.
template <typename Filter>
void run(std::vector<humanmodel::SkeletonFrame>& frames, const Filter& fresh, bool backwards) {
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    Filter filter = fresh;
    for (std::size_t k = 0; k < frames.size(); ++k) {
      humanmodel::SkeletonFrame& f = frames[backwards ? frames.size() - 1 - k : k];
      if (f.state[j] == humanmodel::JointState::kMissing)
        filter.reset();
      else
        f.p[j] = filter.step(f.p[j]);
    }
  }
}

}  // namespace

Butterworth::Butterworth(double cutoff, double rate) {
  ABSTAND_CHECK(cutoff > 0.0 && cutoff < 0.5 * rate);
  const double k = std::tan(kPi * cutoff / rate), root2 = std::sqrt(2.0);
  const double norm = 1.0 / (1.0 + root2 * k + k * k);
  b_ = k * k * norm;
  a1_ = 2.0 * (k * k - 1.0) * norm;
  a2_ = (1.0 - root2 * k + k * k) * norm;
  delay_ = root2 / (2.0 * rate * k);
}

Vector3d Butterworth::step(const Vector3d& p) {
  if (!started_) x1_ = x2_ = y1_ = y2_ = p;
  started_ = true;
  const Vector3d y = b_ * (p + 2.0 * x1_ + x2_) - a1_ * y1_ - a2_ * y2_;
  x2_ = x1_;
  x1_ = p;
  y2_ = y1_;
  y1_ = y;
  return y;
}

OneEuro::OneEuro(const Options& options, double rate) : options_(options), dt_(1.0 / rate) {
  ABSTAND_CHECK(rate > 0.0 && options.min_cutoff > 0.0 && options.per_speed >= 0.0);
}

Vector3d OneEuro::step(const Vector3d& p) {
  if (!started_) {
    p_ = raw_ = p;
    v_.setZero();
    started_ = true;
    return p;
  }
  v_ += lowPassShare(kSpeedCutoff, dt_) * ((p - raw_) / dt_ - v_);
  raw_ = p;
  p_ += lowPassShare(options_.min_cutoff + options_.per_speed * v_.norm(), dt_) * (p - p_);
  return p_;
}

double OneEuro::delay(double speed) const {
  return 1.0 / (2.0 * kPi * (options_.min_cutoff + options_.per_speed * speed));
}

const char* smoothingName(Smoothing smoothing) {
  constexpr const char* kNames[]{"one-euro", "butterworth", "butterworth-both-ways"};
  return kNames[static_cast<std::size_t>(smoothing)];
}

std::optional<Smoothing> parseSmoothing(const std::string& name) {
  for (const auto s : {Smoothing::kOneEuro, Smoothing::kButterworth, Smoothing::kButterworthBothWays})
    if (name == smoothingName(s)) return s;
  return std::nullopt;
}

double smoothingCutoff(double rate) { return std::min(kBodyCutoff, rate / 3.0); }

void smooth(std::vector<humanmodel::SkeletonFrame>& frames, double rate, Smoothing smoothing) {
  ABSTAND_CHECK(rate > 0.0);
  if (smoothing == Smoothing::kOneEuro) return run(frames, OneEuro({}, rate), false);
  const Butterworth filter(smoothingCutoff(rate), rate);
  run(frames, filter, false);
  if (smoothing == Smoothing::kButterworthBothWays) run(frames, filter, true);
}

}  // namespace abstand::tracking
