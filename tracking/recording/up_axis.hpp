// Selects the up axis of a recording, and the rotation that makes it z.
#pragma once

#include <string>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

struct UpChoice {
  std::string axis{"y"};  ///< "x", "y", "z", "-x", "-y" or "-z"
  std::string reason;
  std::string warning;  ///< empty: none
};

/// Selects the axis: `wanted` is "auto" or an axis (otherwise UsageError). With "auto" it is the axis nearest
/// to the mean direction from the feet to the head over sampled frames. If that direction varies too much (a
/// person rolling on the floor), the rest pose decides, if it is standing: legs opposite to the trunk. A
/// standing rest pose that contradicts the frames is a warning: the person may be lying all the time.
UpChoice chooseUp(const std::string& wanted, const humanmodel::SkeletonFrame& rest,
                  const std::vector<humanmodel::SkeletonFrame>& frames);

/// The proper rotation that maps `axis` to z and, for an axis other than z, keeps one of the other two: for y
/// up, (x, y, z) -> (x, -z, y).
Matrix3d rotationToZUp(const std::string& axis);

}  // namespace abstand::tracking
