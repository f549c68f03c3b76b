// The joints of Microsoft's trackers, in the order of their files.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// The 25 joints of Kinect v2, as its SDK numbers and names them.
std::span<const std::string> kinectV2Joints();
/// The 20 joints of Kinect v1 in the order of UTD-MHAD (head first), by the names of its list.
std::span<const std::string> utdMhadJoints();
/// The 22 joints of UI-PRMD; each is where the named bone begins.
std::span<const std::string> uiPrmdJoints();
/// The parent of each; -1 for the first, and always smaller than the own index.
std::span<const int> uiPrmdParents();

/// "Tracked", "Inferred" or "NotTracked".
std::optional<humanmodel::JointState> parseTrackingState(std::string_view word);

}  // namespace abstand::tracking
