// A person made by hand, as BVH text.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "core/math/transform.hpp"

namespace abstand::testing {

struct SmallHuman {
  double units_per_metre{100.0};
  Matrix3d R_FW{Matrix3d::Identity()};  ///< from z up, facing x, left y into the axes of the file
  double pelvis_height{0.95};           ///< m above the floor, in the frames
  Matrix3d R_WB{Matrix3d::Identity()};  ///< how the whole body is turned in the frames
  int frames{3};
  std::map<std::string, Matrix3d> turned{};  ///< in all frames, of what starts at a joint; axes of the body
  std::function<std::string(const std::string&)> rename = [](const std::string& name) { return name; };
};

/// Biovision names; along the bones the person is kSmallHumanStature tall, arms hanging. Channels are
/// Zrotation Xrotation Yrotation.
std::string bvhOf(const SmallHuman& human);

inline constexpr double kSmallHumanStature = (0.30 + 0.50 + 0.42 + 0.44) / (1.0 - 0.039);

}  // namespace abstand::testing
