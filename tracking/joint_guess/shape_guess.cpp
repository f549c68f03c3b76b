#include "tracking/joint_guess/shape_guess.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text/message_text.hpp"
#include "tracking/joint_guess/limb_choice.hpp"
#include "tracking/joint_guess/name_guess.hpp"
#include "tracking/joint_guess/name_reading.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;

constexpr double kMaxCost = 14.0;   // sum of squares over nine proportions
constexpr double kClearCost = 1.5;  // distance to the second reading
constexpr double kLegPerArm = 0.491 / 0.332, kTrunkPerLeg = 0.288 / 0.491;
constexpr double kLegPerArmDeviation = 0.2, kTrunkPerLegDeviation = 0.3;
constexpr double kAway = 0.3;       // cosine between the legs and the direction away from the arms' joint
constexpr double kAgreement = 0.8;  // share of the votes for one side
constexpr double kBent = 0.05;      // distance of a bent knee from the line, share of the leg
constexpr double kToePerCalf = 0.48, kHandPerForearm = 0.108 / 0.146;  // as joints are derived
constexpr double kHeadPerTrunk = 0.25, kMaxHeadPerTrunk = 0.8;         // from the neck to the head's base

struct Limbs {
  BranchPair pair;
  LimbChoice choice;
  double length() const { return choice.upper + choice.lower; }
};

struct Reading {
  Limbs legs, arms;
  TreeBranch head;
  double cost{0.0};
};

int nodeOf(const TreeBranch& branch, std::size_t i) { return branch.nodes[i]; }

/// Positions of all joints at one time.
using Places = std::span<const Vector3d>;
const Vector3d& at(Places p, int joint) { return p[static_cast<std::size_t>(joint)]; }

/// Cosine; 0 for a vector of no length.
double cosineOf(const Vector3d& a, const Vector3d& b) {
  const double length = a.norm() * b.norm();
  return length > 0.0 ? a.dot(b) / length : 0.0;
}

class ShapeSearch {
 public:
  explicit ShapeSearch(const SkeletonSample& skeleton) : s_{skeleton}, tree_(skeleton.parents, rest()) {
    poses_.push_back(rest());
    for (const PointFrame& f : s_.frames) {
      const bool all = std::all_of(f.p.begin(), f.p.end(), [](const Vector3d& p) { return p.allFinite(); });
      if (all && f.p.size() == s_.names.size()) poses_.emplace_back(f.p);
    }
  }

  ShapeGuess run() {
    const std::optional<Reading> best = find();
    if (!best) return refuse(reason_);
    const std::optional<bool> a_is_left = sideOfLegs(*best);
    if (!a_is_left) return refuse("left and right are not determined: " + reason_);
    ShapeGuess guess;
    JointMatch& match = guess.match;
    match.joint.fill(-1);
    setLimbs(*best, *a_is_left, match);
    setTrunk(*best, match);
    for (const int j : match.joint) match.mapped += j >= 0 ? 1 : 0;
    const Limbs& legs = best->legs;
    guess.reason = "two branches of " + text::inQuotes(nameOf(legs.pair.a.from)) + " are legs (thigh " +
                   text::rounded(legs.choice.upper / legs.choice.lower, 2) + " of the calf), two of " +
                   text::inQuotes(nameOf(best->arms.pair.a.from)) + " arms (" +
                   text::rounded(best->arms.length() / legs.length(), 2) + " of a leg); left " + side_reason_;
    return guess;
  }

 private:
  Places rest() const { return s_.rest; }
  const std::string& nameOf(int joint) const { return s_.names[static_cast<std::size_t>(joint)]; }
  static ShapeGuess refuse(const std::string& why) {
    ShapeGuess none;
    none.match.joint.fill(-1);
    none.reason = why;
    return none;
  }

  std::optional<Reading> find() {
    const std::vector<BranchPair> pairs = tree_.symmetricPairs();
    reason_ = "found " + std::to_string(pairs.size()) +
              " pairs of symmetric branches, none resembling legs below arms";
    std::vector<std::optional<LimbChoice>> as_leg, as_arm;
    for (const auto& pair : pairs) {
      as_leg.push_back(chooseLimb(pair, LimbKind::kLeg));
      as_arm.push_back(chooseLimb(pair, LimbKind::kArm));
    }
    std::optional<Reading> best;
    double second = kInfinity;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (i == k || !as_leg[i] || !as_arm[k]) continue;
        if (as_leg[i]->cost + as_arm[k]->cost > kMaxCost) continue;
        const auto reading = readingOf({pairs[i], *as_leg[i]}, {pairs[k], *as_arm[k]});
        if (!reading) continue;
        if (!best || reading->cost < best->cost) {
          if (best) second = best->cost;
          best = reading;
        } else {
          second = std::min(second, reading->cost);
        }
      }
    if (best && second - best->cost < kClearCost) {
      reason_ = "two readings of legs and arms are equally good";
      return std::nullopt;
    }
    return best;
  }

  /// Between the hips, or the shoulders, in the rest pose.
  Vector3d middleOf(const Limbs& limbs) const {
    return 0.5 * (at(rest(), nodeOf(limbs.pair.a, limbs.choice.first)) +
                  at(rest(), nodeOf(limbs.pair.b, limbs.choice.first)));
  }

  /// nullopt if the two pairs cannot be the limbs of one person.
  std::optional<Reading> readingOf(Limbs legs, Limbs arms) const {
    const int hips = legs.pair.a.from, chest = arms.pair.a.from;
    if (hips == chest) return std::nullopt;
    for (const TreeBranch* b : {&legs.pair.a, &legs.pair.b})
      if (tree_.isBelow(chest, b->nodes.front())) return std::nullopt;
    for (const TreeBranch* b : {&arms.pair.a, &arms.pair.b})
      if (tree_.isBelow(hips, b->nodes.front())) return std::nullopt;
    Reading r{std::move(legs), std::move(arms), {}, 0.0};
    r.cost = r.legs.choice.cost + r.arms.choice.cost +
             oddness(r.legs.length() / r.arms.length(), kLegPerArm, kLegPerArmDeviation) +
             oddness((middleOf(r.arms) - middleOf(r.legs)).norm() / r.legs.length(), kTrunkPerLeg,
                     kTrunkPerLegDeviation);
    if (r.cost > kMaxCost || !legsPointAway(r)) return std::nullopt;
    const auto head = headOf(r);
    if (!head) return std::nullopt;
    r.head = *head;
    return r;
  }

  bool legsPointAway(const Reading& r) const {
    int away = 0, all = 0;
    for (const Places p : poses_) {
      const Vector3d up = at(p, r.arms.pair.a.from) - at(p, r.legs.pair.a.from);
      ++all;
      bool both = true;
      for (const TreeBranch* b : {&r.legs.pair.a, &r.legs.pair.b})
        both &= cosineOf(at(p, nodeOf(*b, r.legs.choice.last)) - at(p, nodeOf(*b, r.legs.choice.first)), up) <
                -kAway;
      away += both ? 1 : 0;
    }
    return 2 * away > all;
  }

  /// The third branch at the arms' joint that goes farthest away from the legs.
  std::optional<TreeBranch> headOf(const Reading& r) const {
    const int hips = r.legs.pair.a.from, chest = r.arms.pair.a.from;
    const Vector3d up = at(rest(), chest) - at(rest(), hips);
    std::optional<TreeBranch> best;
    double highest = 0.0;
    const auto& children = tree_.children(chest);
    for (std::size_t i = 0; i < std::min<std::size_t>(children.size(), 4 * kMaxBranches); ++i) {
      if (tree_.isBelow(hips, children[i])) continue;
      TreeBranch b = tree_.branch(children[i]);
      if (b.nodes.empty() || b.from < 0) continue;
      const auto shares = [&](const TreeBranch& arm) {
        return tree_.isBelow(arm.nodes.front(), children[i]);
      };
      if (shares(r.arms.pair.a) || shares(r.arms.pair.b)) continue;
      const double height = (at(rest(), b.nodes.back()) - at(rest(), chest)).dot(up);
      if (height <= highest) continue;
      highest = height;
      best = std::move(b);
    }
    return best;
  }

  /// True: branch a of the legs is the left one.
  std::optional<bool> sideOfLegs(const Reading& r) {
    int named_left = 0, named = 0, total = 0;
    const auto count = [&](const TreeBranch& b, NameSide left) {
      for (const int node : b.nodes) {
        const NameSide side = readJointName(nameOf(node)).side;
        ++total;
        named += side != NameSide::kNone ? 1 : 0;
        named_left += side == left ? 1 : 0;
      }
    };
    count(r.legs.pair.a, NameSide::kLeft);
    count(r.legs.pair.b, NameSide::kRight);
    if (named > 0 && named == total && (named_left == named || named_left == 0)) {
      side_reason_ = "by the names";
      return named_left == named;
    }
    int for_a = 0, votes = 0;
    for (const Places p : poses_) {
      const Vector3d up = at(p, r.arms.pair.a.from) - at(p, r.legs.pair.a.from);
      const Vector3d forward = forwardOf(r, p);
      const Vector3d left = up.cross(forward);
      const Vector3d hips = at(p, nodeOf(r.legs.pair.a, r.legs.choice.first)) -
                            at(p, nodeOf(r.legs.pair.b, r.legs.choice.first));
      if (std::abs(cosineOf(left, hips)) < kAway) continue;
      ++votes;
      for_a += left.dot(hips) > 0.0 ? 1 : 0;
    }
    const bool a_is_left = 2 * for_a > votes;
    const int agree = a_is_left ? for_a : votes - for_a;
    reason_ = "toes or knees point forward to one side in " + std::to_string(agree) + " of " +
              std::to_string(votes) + " poses";
    if (votes == 0 || agree < kAgreement * votes) return std::nullopt;
    side_reason_ = "by where toes or knees point, in " + std::to_string(agree) + " of " +
                   std::to_string(votes) + " poses";
    return a_is_left;
  }

  /// Sum over both legs of ankle to toe, or of the bend of the knee where no toe is.
  Vector3d forwardOf(const Reading& r, Places p) const {
    const LimbChoice& c = r.legs.choice;
    Vector3d forward = Vector3d::Zero();
    for (const TreeBranch* b : {&r.legs.pair.a, &r.legs.pair.b}) {
      const Vector3d &hip = at(p, nodeOf(*b, c.first)), &knee = at(p, nodeOf(*b, c.middle)),
                     &ankle = at(p, nodeOf(*b, c.last));
      const Vector3d shin = ankle - knee;
      if (c.last + 1 < b->nodes.size()) {
        const Vector3d foot = at(p, b->nodes.back()) - ankle;
        if (std::abs(cosineOf(foot, shin)) < 0.9) {
          forward += foot.normalized();
          continue;
        }
      }
      const Vector3d bend = knee - 0.5 * (hip + ankle);
      if (bend.norm() > kBent * r.legs.length()) forward += bend.normalized();
    }
    return forward;
  }

  bool firstArmIsOnSideOfFirstLeg(const Reading& r) const {
    int same = 0, all = 0;
    for (const Places p : poses_) {
      const Vector3d hips = at(p, nodeOf(r.legs.pair.a, r.legs.choice.first)) -
                            at(p, nodeOf(r.legs.pair.b, r.legs.choice.first));
      const Vector3d shoulders = at(p, nodeOf(r.arms.pair.a, r.arms.choice.first)) -
                                 at(p, nodeOf(r.arms.pair.b, r.arms.choice.first));
      ++all;
      same += hips.dot(shoulders) > 0.0 ? 1 : 0;
    }
    return 2 * same > all;
  }

  void setLimbs(const Reading& r, bool a_is_left, JointMatch& match) const {
    const auto set = [&](Joint left, bool is_left, int joint) {
      match.joint[static_cast<std::size_t>(left) + (is_left ? 0 : 4)] = joint;
    };
    const auto limb = [&](const TreeBranch& b, const LimbChoice& c, Joint left, bool is_left,
                          double end_per_lower) {
      const auto next = [&](std::size_t i) { return static_cast<Joint>(static_cast<std::size_t>(left) + i); };
      set(next(0), is_left, b.nodes[c.first]);
      set(next(1), is_left, b.nodes[c.middle]);
      set(next(2), is_left, b.nodes[c.last]);
      const auto off = [&](std::size_t i) {
        return std::abs(b.along[i] - b.along[c.last] - end_per_lower * c.lower);
      };
      std::size_t end = c.last + 1;
      for (std::size_t i = end; i < b.nodes.size(); ++i)
        if (off(i) < off(end)) end = i;
      if (end < b.nodes.size()) set(next(3), is_left, b.nodes[end]);
    };
    const bool arm_a_is_left = firstArmIsOnSideOfFirstLeg(r) == a_is_left;
    limb(r.legs.pair.a, r.legs.choice, Joint::kHipLeft, a_is_left, kToePerCalf);
    limb(r.legs.pair.b, r.legs.choice, Joint::kHipLeft, !a_is_left, kToePerCalf);
    limb(r.arms.pair.a, r.arms.choice, Joint::kShoulderLeft, arm_a_is_left, kHandPerForearm);
    limb(r.arms.pair.b, r.arms.choice, Joint::kShoulderLeft, !arm_a_is_left, kHandPerForearm);
  }

  void setTrunk(const Reading& r, JointMatch& match) const {
    const auto set = [&](Joint j, int joint) { match.joint[static_cast<std::size_t>(j)] = joint; };
    const int hips = r.legs.pair.a.from, chest = r.arms.pair.a.from;
    set(Joint::kPelvis, hips);
    std::vector<int> spine = tree_.between(hips, chest);
    const auto& head = r.head.nodes;
    const bool ends_at_site = nameOf(head.back()).ends_with("/end");
    const std::size_t top = head.size() - (ends_at_site && head.size() > 1 ? 1 : 0);  // joints before it
    // Of one joint alone it is the head, and the neck is where the arms leave.
    const bool neck_is_chest = top == 1;
    if (!neck_is_chest) spine.push_back(chest);
    std::erase_if(spine, [&](int j) { return (at(rest(), j) - at(rest(), hips)).norm() == 0.0; });
    if (!spine.empty()) set(Joint::kSpine, spine.front());
    if (spine.size() > 1) set(Joint::kThorax, spine.back());
    set(Joint::kNeck, neck_is_chest ? chest : head.front());
    const double trunk = (at(rest(), head.front()) - at(rest(), hips)).norm();
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

  const SkeletonSample& s_;
  SkeletonTree tree_;
  std::vector<Places> poses_;  ///< the rest pose, and every frame that has all joints
  std::string reason_, side_reason_;
};

}  // namespace

ShapeGuess guessByShape(const SkeletonSample& skeleton) {
  const std::size_t n = skeleton.names.size();
  bool usable = n > 0 && skeleton.parents.size() == n && skeleton.rest.size() == n;
  for (std::size_t i = 0; usable && i < n; ++i)
    usable = skeleton.parents[i] < static_cast<int>(i) && skeleton.rest[i].allFinite();
  if (!usable) {
    ShapeGuess none;
    none.match.joint.fill(-1);
    none.reason = "the file has no hierarchy of joints";
    return none;
  }
  return ShapeSearch(skeleton).run();
}

}  // namespace abstand::tracking
