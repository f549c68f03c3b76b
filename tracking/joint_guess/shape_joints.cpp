#include "tracking/joint_guess/shape_joints.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

using humanmodel::Joint;

constexpr double kToePerCalf = 0.48, kHandPerForearm = 0.108 / 0.146;  // as joints are derived
constexpr double kFarEnd = 0.5;  // deviation from them, share, beyond which an end is something held
constexpr double kHeadPerTrunk = 0.25, kMaxHeadPerTrunk = 0.8;  // from the neck to the head's base

bool firstArmIsOnSideOfFirstLeg(const ShapeReading& r, std::span<const Places> poses) {
  int same = 0, all = 0;
  for (const Places p : poses) {
    ++all;
    same += acrossOf(r.legs, p).dot(acrossOf(*r.arms, p)) > 0.0 ? 1 : 0;
  }
  return 2 * same > all;
}

/// Both limbs of a pair; `left`: the first of the four joints.
void setLimbPair(const Limbs& limbs, Joint left, bool a_is_left, double end_per_lower, JointMatch& match) {
  const LimbChoice& c = limbs.choice;
  const auto limb = [&](const TreeBranch& b, bool is_left) {
    const auto set = [&](std::size_t i, std::size_t node) {
      match.joint[static_cast<std::size_t>(left) + i + (is_left ? 0 : 4)] = b.nodes[node];
    };
    set(0, c.first);
    set(1, c.middle);
    set(2, c.last);
    const double usual = end_per_lower * c.lower;
    const auto off = [&](std::size_t i) { return std::abs(b.along[i] - b.along[c.last] - usual); };
    std::size_t end = c.last + 1;
    for (std::size_t i = end; i < b.nodes.size(); ++i)
      if (off(i) < off(end)) end = i;
    const bool is_own = limbs.pair.is_whole || end < limbs.pair.common;
    if (end < b.nodes.size() && (is_own || off(end) < kFarEnd * usual)) set(3, end);
  };
  limb(limbs.pair.a, a_is_left);
  limb(limbs.pair.b, !a_is_left);
}

void setTrunk(const ShapeReading& r, const SkeletonTree& tree, std::span<const std::string> names,
              Places rest, JointMatch& match) {
  const auto set = [&](Joint j, int joint) { match.joint[static_cast<std::size_t>(j)] = joint; };
  const int hips = r.hips(), chest = r.chest;
  set(Joint::kPelvis, hips);
  std::vector<int> spine = tree.between(hips, chest);
  const auto& head = r.head.nodes;
  const bool ends_at_site = names[static_cast<std::size_t>(head.back())].ends_with("/end");
  const std::size_t top = head.size() - (ends_at_site && head.size() > 1 ? 1 : 0);  // joints before it
  // Of one joint alone it is the head, and the neck is where the arms leave.
  const bool neck_is_chest = top == 1;
  if (!neck_is_chest) spine.push_back(chest);
  std::erase_if(spine, [&](int j) { return (at(rest, j) - at(rest, hips)).norm() == 0.0; });
  if (!spine.empty()) set(Joint::kSpine, spine.front());
  if (spine.size() > 1) set(Joint::kThorax, spine.back());
  set(Joint::kNeck, neck_is_chest ? chest : head.front());
  const double trunk = (at(rest, head.front()) - at(rest, hips)).norm();
  std::size_t base = neck_is_chest ? 0 : 1;
  // The last joint, unless hair or a hat goes on beyond the head.
  if (ends_at_site && r.head.along[top - 1] - r.head.along[0] < kMaxHeadPerTrunk * trunk) base = top - 1;
  for (std::size_t i = base; i < top; ++i)
    if (std::abs(r.head.along[i] - r.head.along[0] - kHeadPerTrunk * trunk) <
        std::abs(r.head.along[base] - r.head.along[0] - kHeadPerTrunk * trunk))
      base = i;
  set(Joint::kHead, head[base]);
  if (base + 1 < head.size()) set(Joint::kHeadTop, head[base + 1]);
}

}  // namespace

JointMatch jointsOf(const ShapeReading& r, bool leg_a_is_left, const SkeletonTree& tree,
                    std::span<const std::string> names, std::span<const Places> poses) {
  JointMatch match;
  match.joint.fill(-1);
  setLimbPair(r.legs, Joint::kHipLeft, leg_a_is_left, kToePerCalf, match);
  if (r.arms) {
    const bool arm_a_is_left = firstArmIsOnSideOfFirstLeg(r, poses) == leg_a_is_left;
    setLimbPair(*r.arms, Joint::kShoulderLeft, arm_a_is_left, kHandPerForearm, match);
  }
  setTrunk(r, tree, names, poses.front(), match);
  for (const int j : match.joint) match.mapped += j >= 0 ? 1 : 0;
  return match;
}

}  // namespace abstand::tracking
