// A rig whose bones are as long as somebody's.
#pragma once

#include <array>
#include <string_view>

#include "tracking/body/body_rig.hpp"

namespace abstand::tracking {

/// What is fitted of a body's size. Left and right are alike.
enum class BodySize : std::uint8_t {
  kStature,  ///< everything, and girths alone
  kHips,     ///< breadth from hip to hip
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

/// Shares of the rig's own sizes: first that of the stature, then what each of the others is beyond it. A
/// segment's axes grow by stature + its own.
using SizeVector = Eigen::Matrix<double, static_cast<int>(kBodySizes), 1>;

/// Nothing changed: (1, 0, 0, ...).
SizeVector sameSizes();

/// By which size each axis (x, y, z) of a segment grows.
const std::array<BodySize, 3>& axisSizes(RigSegment s);

/// By how much the axes of a segment grow.
Vector3d growth(RigSegment s, const SizeVector& sizes);

/// `base` with joints moved accordingly. Shapes stay as they are.
BodyRig resized(const BodyRig& base, const SizeVector& sizes);

/// How a point of segment `s`, at p_S in the base rig, moves with the sizes when no joint turns, world axes.
/// `X_WS` of the resized rig.
Eigen::Matrix<double, 3, static_cast<int>(kBodySizes)> sizeJacobian(const BodyRig& base,
                                                                    const RigPlacement& X_WS, RigSegment s,
                                                                    const Vector3d& p_S);

}  // namespace abstand::tracking
