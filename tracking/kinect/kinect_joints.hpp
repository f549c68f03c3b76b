// Joints of Microsoft's trackers, in file order.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// The 25 joints of Kinect v2, in the order and with the names of its SDK.
std::span<const std::string> kinectV2Joints();
/// The 20 joints of Kinect v1 in the order and with the names of UTD-MHAD (head first).
std::span<const std::string> utdMhadJoints();
/// The 22 joints of UI-PRMD; each is at the start of the named bone.
std::span<const std::string> uiPrmdJoints();
/// Parent index of each; -1 for the first; always smaller than its own.
std::span<const int> uiPrmdParents();

/// "Tracked", "Inferred" or "NotTracked".
std::optional<humanmodel::JointState> parseTrackingState(std::string_view word);

}  // namespace abstand::tracking
