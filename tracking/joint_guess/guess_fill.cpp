#include "tracking/joint_guess/guess_fill.hpp"

#include <algorithm>

#include "tracking/joint_guess/name_guess.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;

constexpr Joint kFilledPairs[]{Joint::kHipLeft, Joint::kShoulderLeft};  // first joints of legs and arms

/// Joint `i` (0 to 3: hip to toe, or shoulder to hand) of one side (0: left).
std::size_t pairJoint(Joint first, int i, int side) {
  return static_cast<std::size_t>(static_cast<int>(first) + i + 4 * side);
}

/// True if the guess takes for one side what the match takes for the other.
bool isCrossed(const JointMatch& match, const JointMatch& guess) {
  for (const Joint first : kFilledPairs)
    for (int i = 0; i < 3; ++i)
      for (int side = 0; side < 2; ++side) {
        const int joint = match.joint[pairJoint(first, i, side)];
        if (joint >= 0 && joint == guess.joint[pairJoint(first, i, 1 - side)]) return true;
      }
  return false;
}

/// True if the pair lacks a joint of `match`, and the guess contradicts none that it has.
bool isToFill(const JointMatch& match, const JointMatch& guess, Joint first) {
  bool is_missing = false;
  for (int i = 0; i < 3; ++i)
    for (int side = 0; side < 2; ++side) {
      const int has = match.joint[pairJoint(first, i, side)], says = guess.joint[pairJoint(first, i, side)];
      is_missing |= has < 0;
      if (has >= 0 && says >= 0 && has != says) return false;
    }
  return is_missing;
}

}  // namespace

bool isIncomplete(const JointMatch& match) {
  return limbJoints(match) < kLimbJointCount || match.joint[static_cast<std::size_t>(Joint::kPelvis)] < 0;
}

std::vector<Joint> fillFrom(JointMatch& match, const JointMatch& guess) {
  std::vector<Joint> added;
  if (isCrossed(match, guess)) return added;
  const auto add = [&](std::size_t j) {
    const int joint = guess.joint[j];
    if (match.joint[j] >= 0 || joint < 0 || std::ranges::find(match.joint, joint) != match.joint.end())
      return;
    match.joint[j] = joint;
    ++match.mapped;
    added.push_back(static_cast<Joint>(j));
  };
  for (const Joint first : kFilledPairs) {
    if (!isToFill(match, guess, first)) continue;
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < 4; ++i) add(pairJoint(first, i, side));
  }
  add(static_cast<std::size_t>(Joint::kPelvis));
  return added;
}

}  // namespace abstand::tracking
