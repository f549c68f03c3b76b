#include "tracking/doctor/doctor.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quantile.hpp"
#include "tracking/recording/part_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr double kUneven = 0.1;
/// Variance of a third difference of white noise, relative to that of the noise.
constexpr double kThirdDifference = 20.0;
/// Median of |x| of a normal distribution, in standard deviations.
constexpr double kMedianOfNormal = 0.6744897501960817;

using Frames = std::vector<humanmodel::SkeletonFrame>;

BoneHealth examineBone(const Frames& frames, const PartJoints& part) {
  const humanmodel::Joint a = part.joints.front(), b = part.joints.back();
  std::vector<double> all;
  for (const auto& f : frames)
    if (f.has(a) && f.has(b)) all.push_back((f[a] - f[b]).norm());
  BoneHealth bone{std::string(part.part)};
  if (all.empty()) return bone;
  bone.length = nearestQuantile(all, 0.5);
  bone.spread = nearestQuantile(all, 0.95) - nearestQuantile(all, 0.05);
  const auto tenth = static_cast<std::ptrdiff_t>(std::max<std::size_t>(all.size() / 10, 1));
  bone.drift = nearestQuantile({all.end() - tenth, all.end()}, 0.5) -
               nearestQuantile({all.begin(), all.begin() + tenth}, 0.5);
  return bone;
}

std::vector<double> speedsOf(const Frames& frames, humanmodel::Joint j) {
  std::vector<double> speeds;
  for (std::size_t i = 1; i < frames.size(); ++i)
    if (frames[i].has(j) && frames[i - 1].has(j) && frames[i].t > frames[i - 1].t)
      speeds.push_back((frames[i][j] - frames[i - 1][j]).norm() / (frames[i].t - frames[i - 1].t));
  return speeds;
}

JointHealth examineJoint(const Frames& frames, humanmodel::Joint j) {
  JointHealth health{std::string(humanmodel::jointName(j))};
  double last_seen = frames.front().t;
  std::size_t missing_before = 0;  // at the last known position
  for (const auto& f : frames) {
    const humanmodel::JointState state = f.state[static_cast<std::size_t>(j)];
    health.missing += state == humanmodel::JointState::kMissing ? 1 : 0;
    health.inferred += state == humanmodel::JointState::kInferred ? 1 : 0;
    if (health.missing > missing_before) health.longest_gap = std::max(health.longest_gap, f.t - last_seen);
    if (state == humanmodel::JointState::kMissing) continue;
    last_seen = f.t;
    missing_before = health.missing;
  }
  health.jitter = jitterOf(frames, j);
  const double speed = nearestQuantile(speedsOf(frames, j), 0.5);
  health.speed = std::isfinite(speed) ? speed : 0.0;
  return health;
}

std::vector<Jump> findJumps(const Frames& frames) {
  std::vector<Jump> jumps;
  for (std::size_t i = 1; i < frames.size(); ++i)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      const auto joint = static_cast<humanmodel::Joint>(j);
      if (!frames[i].has(joint) || !frames[i - 1].has(joint)) continue;
      const double dt = frames[i].t - frames[i - 1].t,
                   displacement = (frames[i][joint] - frames[i - 1][joint]).norm();
      if (displacement > kFastestJoint * dt)
        jumps.push_back({std::string(humanmodel::jointName(joint)), frames[i].t, displacement / dt});
    }
  return jumps;
}

/// True if left and right of the torso are exchanged between two frames.
bool isSwap(const humanmodel::SkeletonFrame& a, const humanmodel::SkeletonFrame& b) {
  double straight = 0.0, crossed = 0.0;
  int pairs = 0;
  for (const auto& [left, right] :
       {std::pair{humanmodel::Joint::kHipLeft, humanmodel::Joint::kHipRight},
        std::pair{humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kShoulderRight}}) {
    if (!a.has(left) || !a.has(right) || !b.has(left) || !b.has(right)) continue;
    straight += (a[left] - b[left]).norm() + (a[right] - b[right]).norm();
    crossed += (a[left] - b[right]).norm() + (a[right] - b[left]).norm();
    ++pairs;
  }
  return pairs > 0 && crossed < straight;
}

double medianJitter(const Frames& frames) {
  std::vector<double> values;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (const double v = jitterOf(frames, static_cast<humanmodel::Joint>(j)); std::isfinite(v))
      values.push_back(v);
  return nearestQuantile(std::move(values), 0.5);
}

FilterHealth tryFilter(const Frames& frames, double rate, double speed, Smoothing smoothing) {
  FilterHealth health{smoothingName(smoothing)};
  Frames after = frames;
  smooth(after, rate, smoothing);
  health.jitter_before = medianJitter(frames);
  health.jitter_after = medianJitter(after);
  std::vector<double> moved;
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (frames[i].state[j] != humanmodel::JointState::kMissing)
        moved.push_back((frames[i].p[j] - after[i].p[j]).norm());
  health.moved = moved.empty() ? 0.0 : nearestQuantile(std::move(moved), 0.99);
  if (smoothing == Smoothing::kOneEuro) {
    const OneEuro filter({}, rate);
    health.delay = filter.delay(speed);
    health.delay_at_rest = filter.delay(0.0);
  } else if (smoothing == Smoothing::kButterworth) {
    health.delay = health.delay_at_rest = Butterworth(smoothingCutoff(rate), rate).delay();
  }
  return health;
}

}  // namespace

double jitterOf(const Frames& frames, humanmodel::Joint j) {
  std::vector<double> differences;
  for (std::size_t i = 3; i < frames.size(); ++i) {
    const auto &a = frames[i - 3], &b = frames[i - 2], &c = frames[i - 1], &d = frames[i];
    if (!a.has(j) || !b.has(j) || !c.has(j) || !d.has(j)) continue;
    const Vector3d third = d[j] - 3.0 * c[j] + 3.0 * b[j] - a[j];
    for (int k = 0; k < 3; ++k) differences.push_back(std::abs(third[k]));
  }
  return nearestQuantile(std::move(differences), 0.5) / (kMedianOfNormal * std::sqrt(kThirdDifference));
}

DoctorReport examine(const Recording& recording) {
  const Frames& frames = recording.frames;
  DoctorReport report;
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i) steps.push_back(frames[i].t - frames[i - 1].t);
  if (!steps.empty()) {
    report.step = nearestQuantile(steps, 0.5);
    report.longest_step = nearestQuantile(steps, 1.0);
    report.uneven_steps = static_cast<std::size_t>(std::count_if(steps.begin(), steps.end(), [&](double s) {
      return std::abs(s - report.step) > kUneven * report.step;
    }));
  }
  for (const auto& part : partJoints())
    if (auto bone = examineBone(frames, part); bone.length > 0.0) report.bones.push_back(std::move(bone));
  std::vector<double> speeds;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    auto joint = examineJoint(frames, static_cast<humanmodel::Joint>(j));
    if (joint.missing == frames.size()) continue;
    speeds.push_back(joint.speed);
    report.joints.push_back(std::move(joint));
  }
  report.jumps = findJumps(frames);
  for (std::size_t i = 1; i < frames.size(); ++i)
    if (isSwap(frames[i - 1], frames[i])) report.swaps.push_back(frames[i].t);
  if (report.step > 0.0 && !speeds.empty()) {
    const double speed = nearestQuantile(speeds, 0.5);
    for (const auto s : {Smoothing::kOneEuro, Smoothing::kButterworth, Smoothing::kButterworthBothWays})
      report.filters.push_back(tryFilter(frames, 1.0 / report.step, speed, s));
  }
  Frames copy = frames;
  report.fill = fillGaps(copy, kShortGap);
  return report;
}

}  // namespace abstand::tracking
