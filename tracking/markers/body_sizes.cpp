#include "tracking/markers/body_sizes.hpp"

namespace abstand::tracking {
namespace {

constexpr std::array<std::string_view, kBodySizes> kNames{
    "stature", "hips", "trunk", "shoulders", "head", "upper_arm", "forearm", "hand", "thigh", "calf", "foot"};

constexpr std::array<BodySize, 3> along(BodySize size) {
  return {BodySize::kStature, BodySize::kStature, size};
}

// In the order of RigSegment.
constexpr auto kAxisSizes = [] {
  using enum BodySize;
  return std::array<std::array<BodySize, 3>, kRigSegments>{{{kStature, kHips, kTrunk},
                                                            {kStature, kShoulders, kTrunk},
                                                            along(kHead),
                                                            along(kUpperArm),
                                                            along(kUpperArm),
                                                            along(kForearm),
                                                            along(kForearm),
                                                            along(kHand),
                                                            along(kHand),
                                                            along(kThigh),
                                                            along(kThigh),
                                                            along(kCalf),
                                                            along(kCalf),
                                                            {kFoot, kStature, kStature},
                                                            {kFoot, kStature, kStature}}};
}();

}  // namespace

std::string_view sizeName(BodySize size) { return kNames[index(size)]; }

SizeVector sameSizes() { return SizeVector::Unit(0); }

const std::array<BodySize, 3>& axisSizes(RigSegment s) { return kAxisSizes[index(s)]; }

Vector3d growth(RigSegment s, const SizeVector& sizes) {
  Vector3d by = Vector3d::Constant(sizes[0]);
  for (int k = 0; k < 3; ++k) {
    const BodySize own = axisSizes(s)[static_cast<std::size_t>(k)];
    if (own != BodySize::kStature) by[k] += sizes[static_cast<int>(index(own))];
  }
  return by;
}

BodyRig resized(const BodyRig& base, const SizeVector& sizes) {
  BodyRig rig = base;
  rig.height = base.height * sizes[0];
  for (std::size_t i = 1; i < kRigSegments; ++i)
    rig.parts[i].p_parent = growth(base.parts[i].parent, sizes).cwiseProduct(base.parts[i].p_parent);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    rig.p_joint[j] = growth(base.carrier[j], sizes).cwiseProduct(base.p_joint[j]);
  return rig;
}

Eigen::Matrix<double, 3, static_cast<int>(kBodySizes)> sizeJacobian(const BodyRig& base,
                                                                    const RigPlacement& X_WS, RigSegment s,
                                                                    const Vector3d& p_S) {
  Eigen::Matrix<double, 3, static_cast<int>(kBodySizes)> J;
  J.setZero();
  const auto grow = [&](RigSegment segment, const Vector3d& p) {
    const auto& R_WS = X_WS[index(segment)].linear();
    J.col(0) += R_WS * p;
    for (int k = 0; k < 3; ++k) {
      const BodySize own = axisSizes(segment)[static_cast<std::size_t>(k)];
      if (own != BodySize::kStature) J.col(static_cast<int>(index(own))) += R_WS.col(k) * p[k];
    }
  };
  grow(s, p_S);
  for (; s != RigSegment::kPelvis; s = base[s].parent) grow(base[s].parent, base[s].p_parent);
  return J;
}

}  // namespace abstand::tracking
