#include "tracking/joint_guess/guess_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/quantile.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;

constexpr double kSidesDiffer = 0.15;
constexpr double kShortestUpper = 0.6, kLongestThigh = 1.8, kLongestUpperArm = 2.2;  // of the lower bone
constexpr double kShortestLeg = 0.9, kLongestLeg = 2.5;                              // of the arm
constexpr double kFarthestPelvis = 0.6;                                              // of the thigh

struct CheckedLimb {
  const char* name;
  Joint first;  ///< on the left; the others follow, the right ones 4 later
  double longest_upper;
};
constexpr CheckedLimb kCheckedLegs{"legs", Joint::kHipLeft, kLongestThigh},
    kCheckedArms{"arms", Joint::kShoulderLeft, kLongestUpperArm};

Joint limbJoint(const CheckedLimb& limb, int i, int side) {
  return static_cast<Joint>(static_cast<int>(limb.first) + i + 4 * side);
}

/// Median distance; NaN if the joints never occur together.
double lengthOf(std::span<const humanmodel::SkeletonFrame> frames, Joint a, Joint b) {
  std::vector<double> lengths;
  for (const auto& f : frames)
    if (f.has(a) && f.has(b)) lengths.push_back((f[a] - f[b]).norm());
  return nearestQuantile(std::move(lengths), 0.5);
}

void remove(JointMatch& match, const CheckedLimb& limb) {
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < 4; ++i) {
      int& joint = match.joint[static_cast<std::size_t>(limbJoint(limb, i, side))];
      if (joint >= 0) --match.mapped;
      joint = -1;
    }
}

/// What is wrong with a pair of limbs; empty: nothing that shows.
std::string faultOf(const CheckedLimb& limb, std::span<const humanmodel::SkeletonFrame> frames) {
  double length[2][2];
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < 2; ++i)
      length[side][i] = lengthOf(frames, limbJoint(limb, i, side), limbJoint(limb, i + 1, side));
  for (int i = 0; i < 2; ++i) {
    const double left = length[0][i], right = length[1][i];
    if (std::abs(left - right) > kSidesDiffer * std::max(left, right))
      return "left and right differ by more than 15 %";
  }
  for (const auto& side : length)
    if (const double ratio = side[0] / side[1]; ratio < kShortestUpper || ratio > limb.longest_upper)
      return "the upper bone is " + text::rounded(ratio, 2) + " of the lower one";
  return {};
}

/// Upper and lower bone, mean of both sides.
double limbLength(const CheckedLimb& limb, std::span<const humanmodel::SkeletonFrame> frames) {
  double sum = 0.0;
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < 2; ++i)
      sum += 0.5 * lengthOf(frames, limbJoint(limb, i, side), limbJoint(limb, i + 1, side));
  return sum;
}

}  // namespace

std::vector<std::string> removeImplausible(JointMatch& match,
                                           std::span<const humanmodel::SkeletonFrame> frames) {
  std::vector<std::string> said;
  for (const CheckedLimb& limb : {kCheckedLegs, kCheckedArms})
    if (const std::string fault = faultOf(limb, frames); !fault.empty()) {
      said.push_back(std::string("the ") + limb.name + " that the names suggest are not used: " + fault);
      remove(match, limb);
    }
  const double ratio = limbLength(kCheckedLegs, frames) / limbLength(kCheckedArms, frames);
  if (said.empty() && (ratio < kShortestLeg || ratio > kLongestLeg)) {
    said.push_back("the limbs suggested by the names are not used: a leg is " + text::rounded(ratio, 2) +
                   " of an arm");
    remove(match, kCheckedLegs);
    remove(match, kCheckedArms);
  }
  return said;
}

void removeDistantPelvis(JointMatch& match, std::span<const humanmodel::SkeletonFrame> frames) {
  const auto pelvis = static_cast<std::size_t>(Joint::kPelvis);
  if (match.joint[pelvis] < 0) return;
  std::vector<double> distances;
  for (const auto& f : frames)
    if (f.has(Joint::kPelvis) && f.has(Joint::kHipLeft) && f.has(Joint::kHipRight))
      distances.push_back((f[Joint::kPelvis] - 0.5 * (f[Joint::kHipLeft] + f[Joint::kHipRight])).norm());
  const double thigh = lengthOf(frames, Joint::kHipLeft, Joint::kKneeLeft);
  if (!(nearestQuantile(std::move(distances), 0.5) > kFarthestPelvis * thigh)) return;
  match.joint[pelvis] = -1;
  --match.mapped;
}

}  // namespace abstand::tracking
