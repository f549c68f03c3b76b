#include "tracking/joint_guess/leg_sides.hpp"

#include <cmath>

#include "tracking/joint_guess/name_reading.hpp"

namespace abstand::tracking {
namespace {

constexpr double kAcross = 0.3;      // cosine between the line of the hips and left by toes or knees
constexpr double kAgreement = 0.8;   // share of the votes for one side
constexpr double kBent = 0.05;       // distance of a bent knee from the line, share of the leg
constexpr double kStraightOn = 0.9;  // cosine between a foot and a shin of which it is the continuation

/// The last node of a leg; of legs that differ behind common nodes, the last common one.
int footEnd(const Limbs& legs, const TreeBranch& branch) {
  const bool is_common = !legs.pair.is_whole && legs.pair.common > legs.choice.last + 1;
  return is_common ? branch.nodes[legs.pair.common - 1] : branch.nodes.back();
}

/// Sum over both legs of ankle to toe, or of the bend of the knee where no toe is.
Vector3d forwardOf(const ShapeReading& r, Places p) {
  const LimbChoice& c = r.legs.choice;
  Vector3d forward = Vector3d::Zero();
  for (const TreeBranch* b : {&r.legs.pair.a, &r.legs.pair.b}) {
    const Vector3d &hip = at(p, b->nodes[c.first]), &knee = at(p, b->nodes[c.middle]),
                   &ankle = at(p, b->nodes[c.last]);
    const Vector3d shin = ankle - knee;
    if (c.last + 1 < b->nodes.size()) {
      const Vector3d foot = at(p, footEnd(r.legs, *b)) - ankle;
      if (std::abs(cosineOf(foot, shin)) < kStraightOn) {
        forward += foot.normalized();
        continue;
      }
    }
    if (!r.arms) continue;
    const Vector3d bend = knee - 0.5 * (hip + ankle);
    if (bend.norm() > kBent * r.legs.length()) forward += bend.normalized();
  }
  return forward;
}

/// By the names, if all joints of the legs say the same side.
std::optional<bool> sideByNames(const ShapeReading& r, std::span<const std::string> names) {
  int named_left = 0, named = 0, total = 0;
  const auto count = [&](const TreeBranch& b, NameSide left) {
    for (const int node : b.nodes) {
      const NameSide side = readJointName(names[static_cast<std::size_t>(node)]).side;
      ++total;
      named += side != NameSide::kNone ? 1 : 0;
      named_left += side == left ? 1 : 0;
    }
  };
  count(r.legs.pair.a, NameSide::kLeft);
  count(r.legs.pair.b, NameSide::kRight);
  if (named == 0 || named < total || (named_left != named && named_left != 0)) return std::nullopt;
  return named_left == named;
}

}  // namespace

LegSides sidesOfLegs(const ShapeReading& r, std::span<const std::string> names,
                     std::span<const Places> poses) {
  if (const auto a_is_left = sideByNames(r, names)) return {a_is_left, "by the names"};
  int for_a = 0, votes = 0;
  for (const Places p : poses) {
    const Vector3d left = upOf(r, p).cross(forwardOf(r, p));
    const Vector3d hips = acrossOf(r.legs, p);
    if (std::abs(cosineOf(left, hips)) < kAcross) continue;
    ++votes;
    for_a += left.dot(hips) > 0.0 ? 1 : 0;
  }
  const bool a_is_left = 2 * for_a > votes;
  const int agree = a_is_left ? for_a : votes - for_a;
  const std::string poses_text = std::to_string(agree) + " of " + std::to_string(votes) + " poses";
  const std::string what = r.arms ? "toes or knees" : "toes";
  if (votes == 0 || agree < kAgreement * votes)
    return {std::nullopt, what + " point forward to one side in " + poses_text};
  return {a_is_left, "by where " + what + " point, in " + poses_text};
}

}  // namespace abstand::tracking
