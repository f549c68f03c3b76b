#include "tracking/bvh/lost_bones.hpp"

#include <algorithm>
#include <optional>

#include "core/math/quantile.hpp"
#include "tracking/bvh/bvh_pose.hpp"
#include "tracking/joint_guess/limb_choice.hpp"

namespace abstand::tracking {
namespace {

constexpr double kShortSpine = 0.34;  // of a leg
constexpr double kShortHand = 0.5;    // of a forearm
constexpr double kWristBone = 0.5;    // of the forearm, as in CMU's ASF
/// Of the leg, 14 mm for 0.8 m: what rounding and re-export leave of an OFFSET of 0. In files that have these
/// bones, necks and collars begin 0.10 of a leg and more from the chest.
constexpr double kNoOffset = 0.018;
constexpr double kMaxLimbCost = 14.0;  // of a leg and of an arm, as in a guess by shape

class BoneRepair {
 public:
  explicit BoneRepair(BvhHierarchy& hierarchy) : h_{hierarchy}, children_(hierarchy.joints.size()) {
    for (std::size_t i = 0; i < h_.joints.size(); ++i) {
      parents_.push_back(h_.joints[i].parent);
      if (h_.joints[i].parent >= 0)
        children_[static_cast<std::size_t>(h_.joints[i].parent)].push_back(static_cast<int>(i));
    }
  }

  std::vector<LostBone> run() {
    BvhPose pose(h_);
    pose.setRest();
    const SkeletonTree tree(parents_, pose.positions());
    const std::vector<BranchPair> pairs = tree.symmetricPairs();
    for (const BranchPair& arms : pairs)
      for (const BranchPair& legs : pairs) {
        if (legs.a.from == arms.a.from || !tree.isBelow(arms.a.from, legs.a.from)) continue;
        if (tree.isBelow(arms.a.from, legs.a.nodes.front()) ||
            tree.isBelow(arms.a.from, legs.b.nodes.front()))
          continue;
        const auto leg = chooseLimb(legs, LimbKind::kLeg), arm = chooseLimb(arms, LimbKind::kArm);
        if (!leg || !arm || leg->cost > kMaxLimbCost || arm->cost > kMaxLimbCost) continue;
        if (repairThorax(legs, arms.a.from, leg->upper + leg->lower)) {
          const double no_offset = kNoOffset * (leg->upper + leg->lower);
          for (const TreeBranch* side : {&arms.a, &arms.b}) repairHand(*side, *arm, no_offset);
          return std::move(found_);
        }
      }
    return {};
  }

 private:
  BvhJoint& joint(int i) { return h_.joints[static_cast<std::size_t>(i)]; }

  /// True if all children, at least `fewest`, coincide with the joint and stay there.
  bool hasNoOffsets(int i, std::size_t fewest, double no_offset) {
    const auto& children = children_[static_cast<std::size_t>(i)];
    return children.size() >= fewest && std::all_of(children.begin(), children.end(), [&](int c) {
             const auto& channels = joint(c).channels;
             return joint(c).offset.norm() <= no_offset &&
                    std::none_of(channels.begin(), channels.end(),
                                 [](BvhChannel channel) { return channel <= BvhChannel::kZPosition; });
           });
  }

  bool putIn(int i, double length, bool is_hand) {
    const double own = joint(i).offset.norm();
    if (!(own > 0.0) || !(length > 0.0)) return false;
    const Vector3d bone = length / own * joint(i).offset;
    for (const int c : children_[static_cast<std::size_t>(i)]) joint(c).offset += bone;
    found_.push_back({joint(i).name, length, is_hand});
    return true;
  }

  bool repairThorax(const BranchPair& legs, int chest, double leg) {
    if (!hasNoOffsets(chest, 3, kNoOffset * leg)) return false;
    std::vector<double> bones;
    double spine = 0.0;
    for (int i = chest; i != legs.a.from && i >= 0; i = joint(i).parent) {
      const double length = joint(i).offset.norm();
      spine += length;
      if (length > kNoOffset * leg) bones.push_back(length);
    }
    if (bones.empty() || spine > kShortSpine * leg) return false;
    return putIn(chest, nearestQuantile(bones, 0.5), false);
  }

  void repairHand(const TreeBranch& side, const LimbChoice& arm, double no_offset) {
    const int wrist = side.nodes[arm.last];
    const double hand = side.length - side.along[arm.last],
                 forearm = side.along[arm.last] - side.along[arm.middle];
    if (hasNoOffsets(wrist, 1, no_offset) && hand < kShortHand * forearm)
      putIn(wrist, kWristBone * forearm, true);
  }

  BvhHierarchy& h_;
  std::vector<int> parents_;
  std::vector<std::vector<int>> children_;
  std::vector<LostBone> found_;
};

}  // namespace

std::vector<LostBone> repairLostBones(BvhHierarchy& hierarchy) { return BoneRepair(hierarchy).run(); }

}  // namespace abstand::tracking
