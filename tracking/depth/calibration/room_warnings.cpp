// What a user should know about a pose from a room.
#include "tracking/depth/calibration/room_warnings.hpp"

#include <cmath>
#include <cstdio>

#include "tracking/depth/calibration/room_choice.hpp"

namespace abstand::tracking {

std::vector<std::string> warningsOf(const RoomFit& fit) {
  std::vector<std::string> warnings;
  char text[300];
  const double turn = kRoomStartTurn / unit::deg(1.0);
  if (std::isfinite(fit.rival)) {
    std::snprintf(
        text, sizeof text,
        "a pose %.2f m away explains the room nearly as well, since parts of it are repeated: this one "
        "is the only one within %.1f m and %.0f degrees of the start",
        fit.rival, kRoomStartMove, turn);
    warnings.emplace_back(text);
  }
  if (!fit.is_start_near) {
    std::snprintf(text, sizeof text,
                  "found a pose %.2f m and %.0f degrees from the start, expected at most %.1f m and %.0f "
                  "degrees: measure the start again, or check the pose",
                  fit.moved, fit.turned / unit::deg(1.0), kRoomStartMove, turn);
    warnings.emplace_back(text);
  }
  if (fit.agreement.weakest < kRoomWeak)
    warnings.emplace_back(
        "few surfaces, as of furniture, determine one direction of the camera: nobody can tell whether they "
        "were moved between the recordings");
  return warnings;
}

}  // namespace abstand::tracking
