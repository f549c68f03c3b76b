// Canonical joints that each of the fourteen body parts needs.
#pragma once

#include <span>
#include <string_view>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// A part can be posed if its first and its last joint are known; joints in between improve it.
struct PartJoints {
  std::string_view part;                      ///< as in scene files
  std::span<const humanmodel::Joint> joints;  ///< from the proximal to the distal one
};

/// All fourteen, in the order of BodyPart.
std::span<const PartJoints> partJoints();

}  // namespace abstand::tracking
