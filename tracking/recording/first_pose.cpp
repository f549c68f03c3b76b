#include "tracking/recording/first_pose.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/transform.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;

constexpr double kStraight = 25.0 * kPi / 180.0, kTurned = 20.0 * kPi / 180.0;

struct Limb {
  Joint first, middle, last;
};
constexpr std::array<Limb, 2> kArms{{{Joint::kShoulderLeft, Joint::kElbowLeft, Joint::kWristLeft},
                                     {Joint::kShoulderRight, Joint::kElbowRight, Joint::kWristRight}}};
constexpr std::array<Limb, 2> kLegs{{{Joint::kHipLeft, Joint::kKneeLeft, Joint::kAnkleLeft},
                                     {Joint::kHipRight, Joint::kKneeRight, Joint::kAnkleRight}}};

/// Angle (rad) between two directions; pi if one of them has no length.
double angleOf(const Vector3d& a, const Vector3d& b) {
  const double lengths = a.norm() * b.norm();
  return lengths > 0.0 ? std::acos(std::clamp(a.dot(b) / lengths, -1.0, 1.0)) : kPi;
}

bool hasLimb(const SkeletonFrame& f, const Limb& limb) {
  return f.has(limb.first) && f.has(limb.middle) && f.has(limb.last);
}

/// True if both bones of a limb point along a direction.
bool pointsAlong(const SkeletonFrame& f, const Limb& limb, const Vector3d& direction) {
  return hasLimb(f, limb) && angleOf(f[limb.middle] - f[limb.first], direction) < kStraight &&
         angleOf(f[limb.last] - f[limb.middle], direction) < kStraight;
}

bool isTPose(const SkeletonFrame& f) {
  if (!f.has(Joint::kShoulderLeft) || !f.has(Joint::kShoulderRight)) return false;
  const Vector3d left = f[Joint::kShoulderLeft] - f[Joint::kShoulderRight];
  Vector3d level = left;
  level.z() = 0.0;
  return angleOf(left, level) < kStraight && pointsAlong(f, kArms[0], level) &&
         pointsAlong(f, kArms[1], -level) && std::all_of(kLegs.begin(), kLegs.end(), [&](const Limb& leg) {
           return pointsAlong(f, leg, -Vector3d::UnitZ());
         });
}

}  // namespace

std::optional<double> leadingTPose(std::span<const SkeletonFrame> frames) {
  if (frames.size() < 2 || !isTPose(frames[0])) return std::nullopt;
  double turned = 0.0;
  for (const Limb& arm : kArms)
    if (hasLimb(frames[1], arm))
      turned = std::max(turned, angleOf(frames[0][arm.last] - frames[0][arm.first],
                                        frames[1][arm.last] - frames[1][arm.first]));
  if (turned <= kTurned) return std::nullopt;
  return turned;
}

}  // namespace abstand::tracking
