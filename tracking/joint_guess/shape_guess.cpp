#include "tracking/joint_guess/shape_guess.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text/message_text.hpp"
#include "tracking/joint_guess/leg_sides.hpp"
#include "tracking/joint_guess/shape_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr double kMaxCost = 14.0;     // sum of squares over nine proportions
constexpr double kMaxLegsCost = 6.0;  // over four
constexpr double kClearCost = 1.5;    // distance to the second reading
constexpr double kLegPerArm = 0.491 / 0.332, kTrunkPerLeg = 0.288 / 0.491;
constexpr double kLegPerArmDeviation = 0.2, kTrunkPerLegDeviation = 0.3;
constexpr double kUpperBodyPerLeg = 0.470 / 0.491, kUpperBodyPerLegDeviation = 0.2;  // hips to vertex
constexpr double kNeckPerUpperBody = 0.288 / 0.470;
/// Height of the shoulders above the hips, share of that of the vertex; trees end at different places there.
constexpr double kShouldersPerUpperBody = kNeckPerUpperBody, kShouldersPerUpperBodyDeviation = 0.15;
constexpr double kHanging =
    0.1;  // share of the trunk, by which a head ends above its longest branch with hair
constexpr double kOtherLimbs = 0.5;  // length of further pairs of branches, share of the legs
constexpr double kAway = 0.3;        // cosine between the legs and the direction away from the arms' joint
constexpr std::size_t kMaxNearChest = 2;  // joints between those that arms and head leave
constexpr std::size_t kMaxAncestors = 8;  // from the hips to the joint that the trunk leaves

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
    const std::optional<ShapeReading> best = find();
    if (!best) return refuse(reason_);
    const LegSides sides = sidesOfLegs(*best, s_.names, poses_);
    if (!sides.a_is_left) return refuse("left and right are not determined: " + sides.reason);
    ShapeGuess guess;
    guess.match = jointsOf(*best, *sides.a_is_left, tree_, s_.names, poses_);
    const Limbs& legs = best->legs;
    guess.reason = "two branches of " + text::inQuotes(nameOf(best->hips())) + " are legs (thigh " +
                   text::rounded(legs.choice.upper / legs.choice.lower, 2) + " of the calf), ";
    guess.reason += best->arms ? "two of " + text::inQuotes(nameOf(best->chest)) + " arms (" +
                                     text::rounded(best->arms->length() / legs.length(), 2) + " of a leg)"
                               : "no two are arms, so that arms are missing";
    guess.reason += "; left " + sides.reason;
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

  /// Of symmetric branches; otherwise also of those that something in a hand or on a foot makes unequal;
  /// otherwise legs without arms.
  std::optional<ShapeReading> find() {
    std::vector<BranchPair> pairs = tree_.symmetricPairs();
    reason_ = "found " + std::to_string(pairs.size()) +
              " pairs of symmetric branches, none resembling legs below arms";
    auto best = bestOf(wholeReadings(pairs));
    if (best || is_ambiguous_) return best;
    for (BranchPair& pair : tree_.partlySymmetricPairs()) pairs.push_back(std::move(pair));
    best = bestOf(wholeReadings(pairs));
    if (best || is_ambiguous_) return best;
    return bestOf(legReadings(pairs));
  }

  /// Where the limbs of a reading begin, for messages.
  std::string limbsOf(const ShapeReading& r) const {
    const auto pair = [&](const Limbs& limbs) {
      return text::inQuotes(nameOf(limbs.pair.a.nodes[limbs.choice.first])) + " and " +
             text::inQuotes(nameOf(limbs.pair.b.nodes[limbs.choice.first]));
    };
    return "legs from " + pair(r.legs) + (r.arms ? " with arms from " + pair(*r.arms) : std::string());
  }

  std::optional<ShapeReading> bestOf(std::vector<ShapeReading> readings) {
    if (readings.empty()) return std::nullopt;
    std::stable_sort(readings.begin(), readings.end(),
                     [](const ShapeReading& a, const ShapeReading& b) { return a.cost < b.cost; });
    is_ambiguous_ = readings.size() > 1 && readings[1].cost - readings[0].cost < kClearCost;
    if (!is_ambiguous_) return std::move(readings.front());
    reason_ = "two readings of legs and arms are equally good: " + limbsOf(readings[0]) + ", or " +
              limbsOf(readings[1]);
    return std::nullopt;
  }

  /// The best two readings with legs and arms.
  std::vector<ShapeReading> wholeReadings(const std::vector<BranchPair>& pairs) const {
    std::vector<std::optional<LimbChoice>> as_leg, as_arm;
    for (const auto& pair : pairs) {
      as_leg.push_back(chooseLimb(pair, LimbKind::kLeg));
      as_arm.push_back(chooseLimb(pair, LimbKind::kArm));
    }
    std::vector<ShapeReading> best;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (i == k || !as_leg[i] || !as_arm[k]) continue;
        if (as_leg[i]->cost + as_arm[k]->cost > kMaxCost) continue;
        if (auto reading = readingOf({pairs[i], *as_leg[i]}, {pairs[k], *as_arm[k]}))
          addBest(std::move(*reading), best);
      }
    return best;
  }

  /// The best two readings with legs below a trunk and without another pair of limbs.
  std::vector<ShapeReading> legReadings(const std::vector<BranchPair>& pairs) const {
    std::vector<ShapeReading> best;
    for (const BranchPair& pair : pairs) {
      const auto legs = chooseLimb(pair, LimbKind::kLeg);
      if (!legs || legs->cost > kMaxLegsCost || hasOtherLimbs(pair, pairs)) continue;
      if (auto reading = readingOf({pair, *legs})) addBest(std::move(*reading), best);
    }
    return best;
  }

  /// Keeps the best two.
  static void addBest(ShapeReading reading, std::vector<ShapeReading>& best) {
    best.push_back(std::move(reading));
    std::stable_sort(best.begin(), best.end(),
                     [](const ShapeReading& a, const ShapeReading& b) { return a.cost < b.cost; });
    if (best.size() > 2) best.pop_back();
  }

  /// True for another pair of long branches that neither belongs to the legs nor leads to them, as animals
  /// and machines have.
  bool hasOtherLimbs(const BranchPair& legs, const std::vector<BranchPair>& pairs) const {
    const int left = legs.a.nodes.front(), right = legs.b.nodes.front();
    return std::any_of(pairs.begin(), pairs.end(), [&](const BranchPair& other) {
      const auto touches = [&](const TreeBranch& b) {
        const int begin = b.nodes.front();
        return tree_.isBelow(begin, left) || tree_.isBelow(begin, right) || tree_.isBelow(left, begin) ||
               tree_.isBelow(right, begin);
      };
      return other.length > kOtherLimbs * legs.length && !touches(other.a) && !touches(other.b);
    });
  }

  /// Between the hips, or the shoulders, in the rest pose.
  Vector3d middleOf(const Limbs& limbs) const {
    return 0.5 * (at(rest(), limbs.pair.a.nodes[limbs.choice.first]) +
                  at(rest(), limbs.pair.b.nodes[limbs.choice.first]));
  }

  /// nullopt if the two pairs cannot be the limbs of one person.
  std::optional<ShapeReading> readingOf(Limbs legs, Limbs arms) const {
    const int hips = legs.pair.a.from, chest = arms.pair.a.from;
    if (hips == chest) return std::nullopt;
    for (const TreeBranch* b : {&legs.pair.a, &legs.pair.b})
      if (tree_.isBelow(chest, b->nodes.front())) return std::nullopt;
    for (const TreeBranch* b : {&arms.pair.a, &arms.pair.b})
      if (tree_.isBelow(hips, b->nodes.front())) return std::nullopt;
    const Vector3d trunk = middleOf(arms) - middleOf(legs);
    ShapeReading r{std::move(legs), std::move(arms), {}, chest, chest, 0.0};
    r.cost = r.legs.choice.cost + r.arms->choice.cost +
             oddness(r.legs.length() / r.arms->length(), kLegPerArm, kLegPerArmDeviation) +
             oddness(trunk.norm() / r.legs.length(), kTrunkPerLeg, kTrunkPerLegDeviation);
    if (r.cost > kMaxCost || !legsPointAway(r)) return std::nullopt;
    const auto head = headOf(r);
    if (!head) return std::nullopt;
    r.head = *head;
    // Arms begin where shoulders are, hair at the head. Not part of the limit, as conventions differ by much.
    const double vertex =
        (at(rest(), r.head.nodes.back()) - middleOf(r.legs)).dot(trunk) / trunk.squaredNorm();
    r.cost += oddness(1.0 / vertex, kShouldersPerUpperBody, kShouldersPerUpperBodyDeviation);
    return r;
  }

  /// Legs with the trunk that fits best; nullopt if none does.
  std::optional<ShapeReading> readingOf(const Limbs& legs) const {
    std::optional<ShapeReading> best;
    int joint = legs.pair.a.from, below = -1;
    for (std::size_t up = 0; up < kMaxAncestors && joint >= 0; ++up) {
      const auto& children = tree_.children(joint);
      for (std::size_t i = 0; i < std::min<std::size_t>(children.size(), 4 * kMaxBranches); ++i) {
        if (children[i] == below || tree_.isBelow(legs.pair.a.nodes.front(), children[i]) ||
            tree_.isBelow(legs.pair.b.nodes.front(), children[i]))
          continue;
        auto reading = withTrunk(legs, tree_.branch(children[i]));
        if (reading && (!best || reading->cost < best->cost)) best = std::move(reading);
      }
      below = joint;
      joint = s_.parents[static_cast<std::size_t>(joint)];
    }
    return best;
  }

  /// The branch as trunk, neck and head of a figure without arms, divided by the usual proportions.
  std::optional<ShapeReading> withTrunk(const Limbs& legs, const TreeBranch& branch) const {
    if (branch.nodes.size() < 2) return std::nullopt;
    const Vector3d middle = middleOf(legs), up = at(rest(), branch.nodes.back()) - middle;
    ShapeReading r{legs, std::nullopt, {}, legs.pair.a.from, -1, 0.0};
    r.cost =
        legs.choice.cost + oddness(up.norm() / legs.length(), kUpperBodyPerLeg, kUpperBodyPerLegDeviation);
    if (r.cost > kMaxLegsCost) return std::nullopt;
    const auto off = [&](std::size_t i) {
      return std::abs((at(rest(), branch.nodes[i]) - middle).dot(up) / up.squaredNorm() - kNeckPerUpperBody);
    };
    std::size_t neck = 0;
    for (std::size_t i = 1; i + 1 < branch.nodes.size(); ++i)
      if (off(i) < off(neck)) neck = i;
    if (neck > 0) r.chest = branch.nodes[neck - 1];
    r.top = branch.nodes[neck];
    const auto from = static_cast<std::ptrdiff_t>(neck);
    r.head.from = r.chest;
    r.head.nodes.assign(branch.nodes.begin() + from, branch.nodes.end());
    r.head.along.assign(branch.along.begin() + from, branch.along.end());
    if (!legsPointAway(r)) return std::nullopt;
    return r;
  }

  bool legsPointAway(const ShapeReading& r) const {
    int away = 0, all = 0;
    for (const Places p : poses_) {
      const Vector3d up = upOf(r, p);
      ++all;
      bool both = true;
      for (const TreeBranch* b : {&r.legs.pair.a, &r.legs.pair.b})
        both &=
            cosineOf(at(p, b->nodes[r.legs.choice.last]) - at(p, b->nodes[r.legs.choice.first]), up) < -kAway;
      away += both ? 1 : 0;
    }
    return 2 * away > all;
  }

  /// The third branch at the arms' joint that goes farthest away from the legs; in a guessed tree also at a
  /// joint of the trunk near it.
  std::optional<TreeBranch> headOf(const ShapeReading& r) const {
    auto head = headAt(r, r.chest, -1);
    int joint = r.chest;
    for (std::size_t i = 0; s_.is_tree_guessed && !head && i < kMaxNearChest; ++i) {
      const int above = s_.parents[static_cast<std::size_t>(joint)];
      if (above < 0 || above == r.hips()) break;
      head = headAt(r, above, joint);
      joint = above;
    }
    return head;
  }

  /// `chest_child`: child of `joint` that leads to the arms; -1: it is their joint.
  std::optional<TreeBranch> headAt(const ShapeReading& r, int joint, int chest_child) const {
    const int hips = r.hips();
    const Vector3d up = upOf(r, rest());
    std::optional<TreeBranch> best;
    double highest = 0.0;
    const auto& children = tree_.children(joint);
    for (std::size_t i = 0; i < std::min<std::size_t>(children.size(), 4 * kMaxBranches); ++i) {
      if (children[i] == chest_child || tree_.isBelow(hips, children[i])) continue;
      const auto shares = [&](const TreeBranch& arm) {
        return tree_.isBelow(arm.nodes.front(), children[i]);
      };
      if (shares(r.arms->pair.a) || shares(r.arms->pair.b)) continue;
      TreeBranch b = headFrom(children[i], up);
      if (b.nodes.empty() || b.from < 0) continue;
      const double height = (at(rest(), b.nodes.back()) - at(rest(), r.chest)).dot(up);
      if (height <= highest) continue;
      highest = height;
      best = std::move(b);
    }
    return best;
  }

  /// The longest branch, or that to the highest joint if hair hangs down below it.
  TreeBranch headFrom(int child, const Vector3d& up) const {
    TreeBranch longest = tree_.branch(child), highest = tree_.highestBranch(child, up);
    if (longest.nodes.empty() || highest.nodes.empty()) return longest;
    const double above = (at(rest(), highest.nodes.back()) - at(rest(), longest.nodes.back())).dot(up);
    return above > kHanging * up.squaredNorm() ? highest : longest;
  }

  const SkeletonSample& s_;
  SkeletonTree tree_;
  std::vector<Places> poses_;  ///< the rest pose, and every frame that has all joints
  std::string reason_;
  bool is_ambiguous_{false};
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
