// Choice among poses of a camera that explain the room that two cameras see.
#pragma once

#include <optional>
#include <vector>

#include "tracking/depth/calibration/room_candidate.hpp"

namespace abstand::tracking {

/// Largest error of the start of fitPoseToRoom().
inline constexpr double kRoomStartMove = 0.2, kRoomStartTurn = unit::deg(20.0);  // m, rad

struct RoomChoice {
  std::size_t best{0};  ///< index
  std::optional<std::size_t>
      rival;           ///< index of the nearest other pose that explains the room nearly as well
  bool decided{true};  ///< without a rival, or by the start
};

/// Share of the common surface that a pose does not explain: on which the cameras do not agree, and
/// kRoomPastCounts times what one of them clearly sees past. Edges are in the first part of every pose, also
/// of the true one, which has nothing of the second.
double unexplained(const RoomAgreement& agreement);

/// The acceptable pose with the smallest unexplained(); among equal ones that with the lowest cost, as among
/// unacceptable ones. The cost alone prefers poses in which the cameras seem to be near each other, since
/// fewer surfaces are hidden from one of them. Rivals are acceptable poses elsewhere (apart()) with at most
/// kRoomNearlyAsWell more, that the same directions determine: at least kRoomWeakerRival of `weakest`. The
/// start decides if exactly one of them is near it and no other explains the room better by kRoomAsWell.
RoomChoice chooseRoomPose(const std::vector<RoomCandidate>& candidates, const Transform& start,
                          const Vector3d& middle_C);

/// Whether the error of the start is within `share` of the allowed one.
bool isNear(const Transform& start, const Transform& X_WC, double share);

/// m, larger one of the displacements of the camera and of the point `middle_C` in its frame.
double apart(const Transform& a, const Transform& b, const Vector3d& middle_C);

/// Smallest distance of different poses: m, and spreads of the less certain one.
inline constexpr double kRoomElsewhere = 0.03, kRoomElsewhereSpreads = 3.0;
/// Measured beyond the true pose (320 x 240): 0.008 to 0.027 where shelves or posts fit to their neighbours,
/// 0.038 and more for racks of three bays, and for a box that was moved and fits to itself.
inline constexpr double kRoomNearlyAsWell = 0.03, kRoomAsWell = 0.005, kRoomPastCounts = 2.0;
/// Measured: 0.1 to 1.6 for repeated parts; 0.04 for a box that was moved, whose pose leaves a wall out.
inline constexpr double kRoomWeakerRival = 0.1;
/// Shares of the allowed error of the start within which the start decides for a pose, and within which a
/// rival is as likely: the start is a rough measurement.
inline constexpr double kRoomStartSlack = 1.05, kRoomStartMargin = 1.25;

}  // namespace abstand::tracking
