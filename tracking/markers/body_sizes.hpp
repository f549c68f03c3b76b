// Scales the rig to the sizes of a person.
#pragma once

#include <array>
#include <string_view>

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// Sizes that are fitted. Left and right are equal.
enum class BodySize : std::uint8_t {
  kStature,  ///< overall scale; alone for girths
  kHips,     ///< distance between the hip joints
  kTrunk,    ///< hips to neck
  kShoulders,
  kHead,
  kUpperArm,
  kForearm,
  kHand,
  kThigh,
  kCalf,
  kFoot,
  kCount
};
inline constexpr std::size_t kBodySizes = static_cast<std::size_t>(BodySize::kCount);
constexpr std::size_t index(BodySize size) { return static_cast<std::size_t>(size); }

/// "stature", "hips", "upper_arm", ...
std::string_view sizeName(BodySize size);

/// Relative sizes: first the overall scale, then additions of the others. A segment's axes scale by stature +
/// their own size.
using SizeVector = Eigen::Matrix<double, static_cast<int>(kBodySizes), 1>;

/// Identity: (1, 0, 0, ...).
SizeVector sameSizes();

/// The size that scales each axis (x, y, z) of a segment.
const std::array<BodySize, 3>& axisSizes(RigSegment s);

/// Scale factors of a segment's axes.
Vector3d growth(RigSegment s, const SizeVector& sizes);

/// `base` with scaled joint positions. Shapes are unchanged.
BodyRig resized(const BodyRig& base, const SizeVector& sizes);

/// Derivative of the position of a point of segment `s`, at p_S in the base rig, by the sizes at constant
/// joint angles, world axes. `X_WS`: poses of the resized rig.
Eigen::Matrix<double, 3, static_cast<int>(kBodySizes)> sizeJacobian(const BodyRig& base,
                                                                    const RigPlacement& X_WS, RigSegment s,
                                                                    const Vector3d& p_S);

}  // namespace abstand::tracking
