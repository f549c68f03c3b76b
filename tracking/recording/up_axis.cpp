#include "tracking/recording/up_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/error.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/derived_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr std::array<const char*, 6> kAxes{"x", "y", "z", "-x", "-y", "-z"};
/// Length of the mean of unit vectors below which the direction varies too much for an upright person.
constexpr double kSteady = 0.6;
/// Cosine between trunk and legs of a standing rest pose.
constexpr double kStanding = 0.7;
/// Cosines of a person who stands along an axis: in most frames, and of the mean direction.
constexpr double kStandsAlong = 0.7, kMeanAlong = 0.9, kNearlyAllFrames = 0.95;
/// m; of the lowest foot above the floor at 0.
constexpr double kFeetOnFloor = 0.3;

/// Mean of the lowest known joints, otherwise nullopt.
std::optional<Vector3d> foot(const humanmodel::SkeletonFrame& f) {
  using J = humanmodel::Joint;
  for (const auto& [left, right] : {std::pair{J::kAnkleLeft, J::kAnkleRight},
                                    {J::kKneeLeft, J::kKneeRight},
                                    {J::kHipLeft, J::kHipRight},
                                    {J::kPelvis, J::kPelvis}})
    if (f.has(left) && f.has(right)) return 0.5 * (f[left] + f[right]);
  return std::nullopt;
}

std::optional<Vector3d> feetToHead(const humanmodel::SkeletonFrame& f) {
  const auto low = foot(f);
  if (!low) return std::nullopt;
  for (const humanmodel::Joint high : {humanmodel::Joint::kHeadTop, humanmodel::Joint::kHead,
                                       humanmodel::Joint::kNeck, humanmodel::Joint::kThorax})
    if (f.has(high) && (f[high] - *low).norm() > 0.0) return (f[high] - *low).normalized();
  return std::nullopt;
}

std::string nearestAxis(const Vector3d& d) {
  int k = 0;
  d.cwiseAbs().maxCoeff(&k);
  return kAxes[static_cast<std::size_t>(d[k] < 0.0 ? k + 3 : k)];
}

/// Smallest coordinate of ankles and toes along a direction; infinity: none is known.
double lowestFootAlong(const std::vector<humanmodel::SkeletonFrame>& frames, const Vector3d& up) {
  using J = humanmodel::Joint;
  double lowest = kInfinity;
  for (const auto& f : frames)
    for (const J j : {J::kAnkleLeft, J::kAnkleRight, J::kToeLeft, J::kToeRight})
      if (f.has(j)) lowest = std::min(lowest, up.dot(f[j]));
  return lowest;
}

/// The up axis of the rest pose, if it is standing.
std::optional<std::string> standingRest(const humanmodel::SkeletonFrame& rest) {
  using J = humanmodel::Joint;
  for (const J j : {J::kPelvis, J::kNeck, J::kHipLeft, J::kHipRight, J::kAnkleLeft, J::kAnkleRight})
    if (!rest.has(j)) return std::nullopt;
  const Vector3d trunk = rest[J::kNeck] - rest[J::kPelvis];
  const Vector3d legs =
      0.5 * (rest[J::kAnkleLeft] + rest[J::kAnkleRight] - rest[J::kHipLeft] - rest[J::kHipRight]);
  if (trunk.dot(legs) > -kStanding * trunk.norm() * legs.norm() || legs.norm() == 0.0) return std::nullopt;
  return nearestAxis(trunk.normalized() - legs.normalized());
}

}  // namespace

UpChoice chooseUp(const std::string& wanted, const humanmodel::SkeletonFrame& rest,
                  const std::vector<humanmodel::SkeletonFrame>& frames) {
  const std::string name = text::lowerCase(wanted);
  if (name != "auto") {
    for (const char* axis : kAxes)
      if (name == axis || name == std::string("+") + axis) return {axis, "given by the user", ""};
    throw UsageError("up: found '" + wanted + "', expected auto, x, y, z, -x, -y or -z");
  }

  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (const auto i : sampleIndices(frames.size()))
    if (const auto d = feetToHead(frames[i])) {
      sum += *d;
      ++count;
    }
  const auto rest_axis = standingRest(rest);
  if (count == 0)
    return {rest_axis.value_or("y"), "no joints that define a direction from feet to head; y is most common",
            "the up axis is unknown: y is assumed; set it if that is wrong"};

  const Vector3d mean = sum / count;
  const std::string measured = "mean direction from feet to head in " + std::to_string(count) + " frames: (" +
                               text::rounded(mean.x(), 2) + ", " + text::rounded(mean.y(), 2) + ", " +
                               text::rounded(mean.z(), 2) + ")";
  const std::string axis = nearestAxis(mean);
  if (!rest_axis || *rest_axis == axis) return {axis, measured, ""};
  if (mean.cwiseAbs().maxCoeff() < kSteady)
    return {*rest_axis, measured + ", which varies; the rest pose stands along " + *rest_axis, ""};
  return {axis, measured + ", although the rest pose stands along " + *rest_axis,
          "the up axis is set to " + axis + " from the motion, although the rest pose stands along " +
              *rest_axis + ": give the axis if the person is lying"};
}

std::string doubtOfUp(const std::string& stated, double scale,
                      const std::vector<humanmodel::SkeletonFrame>& frames) {
  std::vector<Vector3d> directions;
  for (const auto i : sampleIndices(frames.size()))
    if (const auto d = feetToHead(frames[i])) directions.push_back(*d);
  if (directions.empty()) return {};
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& d : directions) mean += d / static_cast<double>(directions.size());
  const std::string axis = nearestAxis(mean);
  const Vector3d up = rotationToZUp(axis).row(2).transpose();
  const auto along =
      std::ranges::count_if(directions, [&](const Vector3d& d) { return up.dot(d) > kStandsAlong; });
  if (axis == stated || up.dot(mean) < kMeanAlong ||
      static_cast<double>(along) < kNearlyAllFrames * static_cast<double>(directions.size()))
    return {};
  const double foot = scale * lowestFootAlong(frames, up);
  if (!(std::abs(foot) <= kFeetOnFloor)) return {};
  return "the person lies along " + axis + " of the file in all frames, with the lowest foot at " + axis +
         " = " + text::rounded(foot, 2) + " m, but " + stated + " is its up axis: if " + axis +
         " is up, give it (--up " + axis + ", in scenes `up: " + axis + "`)";
}

Matrix3d rotationToZUp(const std::string& axis) {
  Matrix3d R = Matrix3d::Identity();
  if (axis == "x") R << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  if (axis == "-x") R << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  if (axis == "y") R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (axis == "-y") R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  if (axis == "-z") R << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  return R;
}

}  // namespace abstand::tracking
