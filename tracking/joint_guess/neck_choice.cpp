#include "tracking/joint_guess/neck_choice.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace abstand::tracking {
namespace {

using humanmodel::Joint;

// Of the trunk, above the shoulders. CMU's lower necks are at -0.12 and below, its upper ones at 0.07 to
// 0.16; the necks of other files at 0 to 0.11.
constexpr double kTooLow = -0.1, kUsualHeight = 0.05;

/// Joints strictly between the neck and the head, from the neck on; empty if the head is not below the neck.
std::vector<int> neckJoints(std::span<const int> parents, int neck, int head) {
  std::vector<int> joints;
  for (int i = parents[static_cast<std::size_t>(head)]; i != neck; i = parents[static_cast<std::size_t>(i)]) {
    if (i < 0) return {};
    joints.insert(joints.begin(), i);
  }
  return joints;
}

}  // namespace

void raiseNeck(std::span<const int> parents, std::span<const Vector3d> rest, JointMatch& match) {
  const auto jointOf = [&](Joint j) { return match.joint[static_cast<std::size_t>(j)]; };
  for (const Joint j :
       {Joint::kPelvis, Joint::kShoulderLeft, Joint::kShoulderRight, Joint::kNeck, Joint::kHead})
    if (jointOf(j) < 0 || static_cast<std::size_t>(jointOf(j)) >= std::min(parents.size(), rest.size()))
      return;
  const auto at = [&](int i) -> const Vector3d& { return rest[static_cast<std::size_t>(i)]; };
  const Vector3d pelvis = at(jointOf(Joint::kPelvis));
  const Vector3d trunk =
      0.5 * (at(jointOf(Joint::kShoulderLeft)) + at(jointOf(Joint::kShoulderRight))) - pelvis;
  const double square = trunk.squaredNorm();
  if (!(square > 0.0)) return;
  // Above the shoulders, share of the trunk.
  const auto height = [&](int i) { return (at(i) - pelvis).dot(trunk) / square - 1.0; };
  int& neck = match.joint[static_cast<std::size_t>(Joint::kNeck)];
  for (const int next : neckJoints(parents, neck, jointOf(Joint::kHead))) {
    const bool is_nearer = std::abs(height(next) - kUsualHeight) < std::abs(height(neck) - kUsualHeight);
    if (height(neck) > kTooLow || !is_nearer) return;
    neck = next;
  }
}

}  // namespace abstand::tracking
