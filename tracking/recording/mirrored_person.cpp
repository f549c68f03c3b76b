#include "tracking/recording/mirrored_person.hpp"

#include <optional>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;

constexpr std::pair<Joint, Joint> kSides[] = {
    {Joint::kShoulderLeft, Joint::kShoulderRight}, {Joint::kElbowLeft, Joint::kElbowRight},
    {Joint::kWristLeft, Joint::kWristRight},       {Joint::kHandLeft, Joint::kHandRight},
    {Joint::kHipLeft, Joint::kHipRight},           {Joint::kKneeLeft, Joint::kKneeRight},
    {Joint::kAnkleLeft, Joint::kAnkleRight},       {Joint::kToeLeft, Joint::kToeRight}};
// m: shorter mean lines define no direction.
constexpr double kNoDirection = 0.01;

/// The vertical plane n . p = d.
struct MirrorPlane {
  Vector3d n;
  double d;
};

/// Plane from the joints of both sides in the frames that have them.
std::optional<MirrorPlane> planeOf(const std::vector<SkeletonFrame>& frames, Joint left, Joint right) {
  Vector3d across = Vector3d::Zero(), middle = Vector3d::Zero();
  double count = 0.0;
  for (const SkeletonFrame& f : frames) {
    if (!f.has(left) || !f.has(right)) continue;
    across += f[right] - f[left];
    middle += 0.5 * (f[right] + f[left]);
    count += 1.0;
  }
  if (count == 0.0) return std::nullopt;
  across.z() = 0.0;
  if (!(across.norm() > kNoDirection * count)) return std::nullopt;
  const Vector3d n = across.normalized();
  return MirrorPlane{n, n.dot(middle) / count};
}

}  // namespace

void mirrorPerson(std::vector<SkeletonFrame>& frames) {
  auto plane = planeOf(frames, Joint::kHipLeft, Joint::kHipRight);
  if (!plane) plane = planeOf(frames, Joint::kShoulderLeft, Joint::kShoulderRight);
  if (!plane)
    throw UsageError(
        "found neither both hips nor both shoulders, expected one pair: the person cannot be "
        "mirrored");
  const Matrix3d reflection = Matrix3d::Identity() - 2.0 * plane->n * plane->n.transpose();
  for (SkeletonFrame& frame : frames) {
    for (std::size_t j = 0; frame.covariance.isStated() && j < humanmodel::kJointCount; ++j)
      frame.covariance[j] = (reflection * frame.covariance[j] * reflection).eval();
    // The reflected y axis of a left part points to the right, as that of no right part does.
    for (std::size_t j = 0; frame.lateral.isStated() && j < humanmodel::kJointCount; ++j)
      frame.lateral[j] = (-reflection.cast<float>() * frame.lateral[j]).eval();
    for (std::size_t i = 0; i < humanmodel::kJointCount; ++i)
      if (frame.has(static_cast<Joint>(i)))
        frame.p[i] -= 2.0 * (plane->n.dot(frame.p[i]) - plane->d) * plane->n;
    for (const auto& [left, right] : kSides) {
      const auto l = static_cast<std::size_t>(left), r = static_cast<std::size_t>(right);
      std::swap(frame.p[l], frame.p[r]);
      std::swap(frame.state[l], frame.state[r]);
      std::swap(frame.spread[l], frame.spread[r]);
      if (frame.covariance.isStated()) std::swap(frame.covariance[l], frame.covariance[r]);
      if (frame.lateral.isStated()) std::swap(frame.lateral[l], frame.lateral[r]);
    }
  }
}

}  // namespace abstand::tracking
