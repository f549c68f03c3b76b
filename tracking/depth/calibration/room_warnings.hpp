// What a user should know about a pose from a room.
#pragma once

#include <string>
#include <vector>

#include "tracking/depth/calibration/room_pose.hpp"

namespace abstand::tracking {

/// Sentences, without a period: if the start decided between repeated parts of the room, and if the start is
/// farther from the pose than allowed.
std::vector<std::string> warningsOf(const RoomFit& fit);

}  // namespace abstand::tracking
