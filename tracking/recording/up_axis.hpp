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

/// A sentence on an axis that the file or its format states, if the person lies in all frames as somebody who
/// stands would with another axis: in 95 % of sampled frames the head is within 45 degrees of that axis as
/// seen from the feet, in the mean within 25 degrees, and the lowest foot of the recording is within 0.3 m of
/// 0 along it. `scale`: metres per unit. Empty: no doubt.
std::string doubtOfUp(const std::string& stated, double scale,
                      const std::vector<humanmodel::SkeletonFrame>& frames);

/// The proper rotation that maps `axis` to z and, for an axis other than z, keeps one of the other two: for y
/// up, (x, y, z) -> (x, -z, y).
Matrix3d rotationToZUp(const std::string& axis);

}  // namespace abstand::tracking
