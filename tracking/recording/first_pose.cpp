#include "tracking/recording/first_pose.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/transform.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;

constexpr double kDegree = kPi / 180.0;
constexpr double kStraight = 25.0 * kDegree, kExact = 8.0 * kDegree, kTurned = 20.0 * kDegree;
/// Legs of a rest pose spread and lean with the root (CMU: 20 degrees outwards), but their knees are exactly
/// straight, unlike those of a person.
constexpr double kLeaning = 45.0 * kDegree, kExactKnee = 3.0 * kDegree;
/// An arm holds the pose within kHeld, and within kWavering and kSlow (rad/s) of the first frame.
constexpr double kHeld = 5.0 * kDegree, kWavering = 1.0 * kDegree, kSlow = 1.0;
/// s; the pose is left within this time, in a step or a blend of some frames.
constexpr double kLeaving = 0.17;
/// rad/s over at most kLeaving: an arm that starts from rest (80 rad/s^2 are those of a fast blow), and one
/// that may be in motion in the first frame.
constexpr double kFromRest = 6.5, kInMotion = 15.0;

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

/// True if both bones of a limb point along a direction, within `off`.
bool pointsAlong(const SkeletonFrame& f, const Limb& limb, const Vector3d& direction, double off) {
  return hasLimb(f, limb) && angleOf(f[limb.middle] - f[limb.first], direction) < off &&
         angleOf(f[limb.last] - f[limb.middle], direction) < off;
}

bool isDown(const SkeletonFrame& f, const Limb& leg) {
  return pointsAlong(f, leg, -Vector3d::UnitZ(), kStraight);
}

bool isExactlyStraight(const SkeletonFrame& f, const Limb& leg) {
  return pointsAlong(f, leg, -Vector3d::UnitZ(), kLeaning) &&
         angleOf(f[leg.middle] - f[leg.first], f[leg.last] - f[leg.middle]) < kExactKnee;
}

/// `off`: largest angle of the arms off the level line of the shoulders.
bool isTPose(const SkeletonFrame& f, double off) {
  if (!f.has(Joint::kShoulderLeft) || !f.has(Joint::kShoulderRight)) return false;
  const Vector3d left = f[Joint::kShoulderLeft] - f[Joint::kShoulderRight];
  Vector3d level = left;
  level.z() = 0.0;
  return angleOf(left, level) < kStraight && pointsAlong(f, kArms[0], level, off) &&
         pointsAlong(f, kArms[1], -level, off) &&
         (std::ranges::all_of(kLegs, [&](const Limb& leg) { return isDown(f, leg); }) ||
          std::ranges::all_of(kLegs, [&](const Limb& leg) { return isExactlyStraight(f, leg); }));
}

/// Angle (rad) by which the arm that turns more differs between two frames.
double turnOf(const SkeletonFrame& a, const SkeletonFrame& b) {
  double turned = 0.0;
  for (const Limb& arm : kArms)
    if (hasLimb(a, arm) && hasLimb(b, arm))
      turned = std::max(turned, angleOf(a[arm.last] - a[arm.first], b[arm.last] - b[arm.first]));
  return turned;
}

/// Number of leading frames in which the arms hold the T-pose of the first one.
std::size_t heldFrames(std::span<const SkeletonFrame> frames) {
  std::size_t held = 1;
  while (held < frames.size() && isTPose(frames[held], kStraight) &&
         turnOf(frames[0], frames[held]) <
             std::min(kHeld, kWavering + kSlow * (frames[held].t - frames[0].t)))
    ++held;
  return held;
}

}  // namespace

std::optional<LeadingTPose> leadingTPose(std::span<const SkeletonFrame> frames) {
  if (frames.size() < 2 || !isTPose(frames[0], kStraight)) return std::nullopt;
  const std::size_t held = heldFrames(frames);
  const bool is_at_rest = held > 1 || isTPose(frames[0], kExact);
  const SkeletonFrame& last = frames[std::min(held, frames.size()) - 1];
  const double fastest = is_at_rest ? kFromRest : kInMotion;
  std::optional<LeadingTPose> found;
  for (std::size_t i = held; i < frames.size(); ++i) {
    const double after = frames[i].t - last.t, turned = turnOf(last, frames[i]);
    if (i > held && after > kLeaving) break;
    const bool is_faster = turned > kTurned && turned > fastest * after;
    // The blend ends where the arm no longer turns at such a speed.
    if (found && (!is_faster || turned - found->turned < 0.5 * fastest * (after - found->seconds))) break;
    if (is_faster) found = LeadingTPose{held, i - held + 1, after, turned};
  }
  return found;
}

std::string warningOf(const LeadingTPose& pose) {
  const std::string which =
      pose.frames == 1 ? "the first frame is" : "frames 1 to " + std::to_string(pose.frames) + " are";
  const std::string when =
      pose.steps == 1 ? "in the next frame" : "in the next " + std::to_string(pose.steps) + " frames";
  return which + " a T-pose; an arm turns by " + text::rounded(pose.turned / kDegree, 0) + " degrees " +
         when + " (" + text::rounded(pose.seconds, 3) +
         " s), faster than a person can: a program added the pose, and its arms are not the person's";
}

}  // namespace abstand::tracking
