#include "tracking/tracker/middle_joints.hpp"

#include <algorithm>
#include <array>

#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;

/// One of each pair. Recordings have spine and thorax elsewhere; toes turn with the person.
constexpr std::array kMiddlesCompared{Joint::kPelvis,       Joint::kNeck,    Joint::kHead,
                                      Joint::kShoulderLeft, Joint::kHipLeft, Joint::kKneeLeft,
                                      Joint::kAnkleLeft};

}  // namespace

humanmodel::SkeletonFrame middleJoints(const humanmodel::SkeletonFrame& frame) {
  humanmodel::SkeletonFrame middle;
  middle.t = frame.t;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    const auto other = static_cast<std::size_t>(mirrored(joint));
    if (frame.state[j] == humanmodel::JointState::kTracked &&
        frame.state[other] == humanmodel::JointState::kTracked)
      middle.set(joint, 0.5 * (frame.p[j] + frame.p[other]));
  }
  return middle;
}

std::optional<Vector3d> offsetBetween(const humanmodel::SkeletonFrame& from,
                                      const humanmodel::SkeletonFrame& to) {
  std::array<std::array<double, kMiddlesCompared.size()>, 3> axes{};
  std::size_t count = 0;
  for (const humanmodel::Joint joint : kMiddlesCompared) {
    if (!from.has(joint) || !to.has(joint)) continue;
    const Vector3d off = to[joint] - from[joint];
    for (std::size_t a = 0; a < 3; ++a) axes[a][count] = off[static_cast<Eigen::Index>(a)];
    ++count;
  }
  if (count < kFewestMiddles) return std::nullopt;
  Vector3d median;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto middle = axes[a].begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(axes[a].begin(), middle, axes[a].begin() + static_cast<std::ptrdiff_t>(count));
    median[static_cast<Eigen::Index>(a)] = *middle;
  }
  return median;
}

}  // namespace abstand::tracking
