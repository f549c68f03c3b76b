// Forward kinematics of a BVH skeleton.
#pragma once

#include <span>
#include <vector>

#include "tracking/bvh/bvh_hierarchy.hpp"

namespace abstand::tracking {

/// BVH uses column vectors: a point in the joint's axes is mapped to its parent's by p_parent = t + R(first
/// channel) R(second channel) R(third channel) p_joint, where t is the OFFSET with every component replaced
/// by the joint's position channel for it, if any (Meredith and Maddock, "Motion Capture File Formats
/// Explained", 2001, section 4). One thread at a time.
class BvhPose {
 public:
  /// `hierarchy` must outlive this object.
  explicit BvhPose(const BvhHierarchy& hierarchy);

  /// Computes positions from the channel values of a frame. No allocation.
  void set(std::span<const double> values);
  /// Rest pose: OFFSETs only, all rotations zero.
  void setRest();

  /// Joint positions in the order of the hierarchy, axes and units of the file.
  const std::vector<Vector3d>& positions() const { return p_; }
  /// Rotations since the rest pose, after set(): of the bones that start at each joint, axes of the file.
  const std::vector<Matrix3d>& rotations() const { return R_; }

 private:
  const BvhHierarchy* hierarchy_;
  std::vector<Vector3d> p_;
  std::vector<Matrix3d> R_;
};

}  // namespace abstand::tracking
