// Bones from hips, hands and feet.
#include "tests/tracking/tracker/posed_person.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::testing {
namespace {

using enum humanmodel::Joint;

constexpr double kFrameRate = 30.0;  // Hz

// Shares of the stature.
constexpr double kThigh = 0.245, kCalf = 0.246, kUpperArm = 0.186, kForearm = 0.146, kHandLength = 0.09;
constexpr double kLoins = 0.14, kUpperBack = 0.148, kNeckUp = 0.03, kHeadUp = 0.152;
constexpr double kHalfHips = 0.05, kHalfShoulders = 0.11, kFootLength = 0.10;

/// Numbers of a posture in one vector, to go from one to the next.
using Numbers = Eigen::Array<double, 16, 1>;
Numbers numbersOf(const Posture& p) {
  Numbers n;
  n << p.hips, p.loins, p.back, p.head, p.reach, p.aside, p.low, p.foot, p.apart, p.ankle, p.toes, p.elbows;
  return n;
}
Posture postureOf(double t, const Numbers& n) {
  return {t, n.head<3>(), n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11], n[12], n.tail<3>()};
}

Posture between(std::span<const Posture> postures, double t) {
  std::size_t k = 0;
  while (k + 1 < postures.size() && postures[k + 1].t <= t) ++k;
  if (k + 1 == postures.size()) return postureOf(t, numbersOf(postures[k]));
  const double s = std::max(0.0, (t - postures[k].t) / (postures[k + 1].t - postures[k].t));
  const double smooth = s * s * (3.0 - 2.0 * s);
  return postureOf(t, (1.0 - smooth) * numbersOf(postures[k]) + smooth * numbersOf(postures[k + 1]));
}

/// The joint between two bones of lengths a and b from `from` towards `to`, bent to the side of `hint`; `to`
/// moves if it is out of reach.
Vector3d bend(const Vector3d& from, Vector3d& to, double a, double b, const Vector3d& hint) {
  const Vector3d line = (to - from).normalized();
  const double d = std::clamp((to - from).norm(), std::abs(a - b) + 0.01, a + b - 0.002);
  to = from + d * line;
  const double along = (a * a - b * b + d * d) / (2.0 * d);
  const Vector3d side = (hint - hint.dot(line) * line).normalized();
  return from + along * line + std::sqrt(std::max(0.0, a * a - along * along)) * side;
}

Vector3d leaning(double angle) { return {std::sin(angle), 0.0, std::cos(angle)}; }

humanmodel::SkeletonFrame frameOf(const Posture& p) {
  constexpr double H = kPosedStature;
  humanmodel::SkeletonFrame f;
  f.t = p.t;
  f.set(kPelvis, p.hips);
  const Vector3d waist = p.hips + kLoins * H * leaning(p.loins);
  const Vector3d shoulders = waist + kUpperBack * H * leaning(p.back);
  f.set(kSpine, waist);
  f.set(kThorax, waist + 0.6 * (shoulders - waist));
  f.set(kNeck, shoulders + kNeckUp * H * leaning(p.back));
  f.set(kHead, f[kNeck] + 0.5 * kHeadUp * H * leaning(p.head));
  f.set(kHeadTop, f[kNeck] + kHeadUp * H * leaning(p.head));
  for (const double side : {1.0, -1.0}) {
    const bool left = side > 0.0;
    const Vector3d out = side * Vector3d::UnitY();
    const Vector3d hip = p.hips + kHalfHips * H * out, shoulder = shoulders + kHalfShoulders * H * out;
    Vector3d ankle(p.foot, side * p.apart, p.ankle);
    Vector3d wrist(p.reach + 0.03 * std::sin(4.0 * p.t + side), side * p.aside, p.low);
    const Vector3d knee = bend(hip, ankle, kThigh * H, kCalf * H, {1.0, 0.1 * side, 0.2});
    const Vector3d elbow =
        bend(shoulder, wrist, kUpperArm * H, kForearm * H, {p.elbows.x(), p.elbows.y() * side, p.elbows.z()});
    f.set(left ? kHipLeft : kHipRight, hip);
    f.set(left ? kKneeLeft : kKneeRight, knee);
    f.set(left ? kAnkleLeft : kAnkleRight, ankle);
    f.set(left ? kToeLeft : kToeRight,
          ankle + kFootLength * H * Vector3d(std::cos(p.toes), 0.1 * side, std::sin(p.toes)));
    f.set(left ? kShoulderLeft : kShoulderRight, shoulder);
    f.set(left ? kElbowLeft : kElbowRight, elbow);
    f.set(left ? kWristLeft : kWristRight, wrist);
    f.set(left ? kHandLeft : kHandRight, wrist + kHandLength * H * (wrist - elbow).normalized());
  }
  return f;
}

}  // namespace

std::vector<humanmodel::SkeletonFrame> posedFrames(std::span<const Posture> postures) {
  std::vector<humanmodel::SkeletonFrame> frames;
  for (int i = 0; i / kFrameRate <= postures.back().t; ++i) {
    Posture p = between(postures, i / kFrameRate);
    p.hips += Vector3d(0.01 * std::sin(2.0 * p.t), 0.015 * std::sin(3.0 * p.t), 0.0);
    frames.push_back(frameOf(p));
  }
  return frames;
}

}  // namespace abstand::testing
