// Which canonical joints each of the fourteen parts of a body needs.
#pragma once

#include <span>
#include <string_view>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// A part moves when its first and its last joint are known; those between make it bend better.
struct PartJoints {
  std::string_view part;                      ///< as in scene files
  std::span<const humanmodel::Joint> joints;  ///< from the proximal to the distal one
};

/// All fourteen, in the order of BodyPart.
std::span<const PartJoints> partJoints();

}  // namespace abstand::tracking
