// Where the joints of a BVH skeleton are.
#pragma once

#include <span>
#include <vector>

#include "tracking/bvh/bvh_hierarchy.hpp"

namespace abstand::tracking {

/// Forward kinematics of a BVH tree. BVH's convention is columns: a point of the joint's axes goes to its
/// parent's by p_parent = t + R(first channel) R(second channel) R(third channel) p_joint, where t is the
/// OFFSET with every component replaced by the position channel that the joint has for it (Meredith and
/// Maddock, "Motion Capture File Formats Explained", 2001, section 4). One thread at a time.
class BvhPose {
 public:
  /// `hierarchy` must outlive this.
  explicit BvhPose(const BvhHierarchy& hierarchy);

  /// From the channel values of a frame. No allocation.
  void set(std::span<const double> values);
  /// As the OFFSETs alone say, all rotations zero.
  void setRest();

  /// Joint positions in the order of the hierarchy, axes and units of the file.
  const std::vector<Vector3d>& positions() const { return p_; }

 private:
  const BvhHierarchy* hierarchy_;
  std::vector<Vector3d> p_;
  std::vector<Matrix3d> R_;
};

}  // namespace abstand::tracking
