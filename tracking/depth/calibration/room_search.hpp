// Search for all poses in which two cameras see the same room.
#pragma once

#include "tracking/depth/calibration/room_choice.hpp"
#include "tracking/depth/calibration/room_rows.hpp"

namespace abstand::tracking {

/// Distinct poses, in the order found: generalised ICP of both clouds (CloudRegistration) and Gauss-Newton
/// from camera().X_WC and from rotated starts, and Gauss-Newton from camera().X_WC alone. If one of these
/// would be taken, also from it displaced along the two directions that the surfaces determine least, in
/// which the room may be repeated: up to kAlong (m) along the weakest, up to kBeside (m) in their plane.
/// Poses that hardly agree are left out, but for the one with the lowest cost.
std::vector<RoomCandidate> searchRoom(const RoomView& known, const RoomView& camera);

inline constexpr double kRoomAlong = 1.0, kRoomBeside = 0.4;  // m

}  // namespace abstand::tracking
