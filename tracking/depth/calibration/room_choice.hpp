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

/// The acceptable pose with the smallest RoomAgreement::seen_through; among equal ones that with the lowest
/// cost, as among unacceptable ones. The cost alone prefers poses in which the cameras seem to be near each
/// other, since fewer surfaces are hidden from one of them. Rivals are acceptable poses elsewhere (apart())
/// whose seen_through is larger by at most kRoomNearlyAsWell. The start decides if exactly one of them is
/// near it and no other explains the room better.
RoomChoice chooseRoomPose(const std::vector<RoomCandidate>& candidates, const Transform& start,
                          const Vector3d& middle_C);

/// m, larger one of the displacements of the camera and of the point `middle_C` in its frame.
double apart(const Transform& a, const Transform& b, const Vector3d& middle_C);

/// Smallest distance of different poses: m, and spreads of the less certain one.
inline constexpr double kRoomElsewhere = 0.03, kRoomElsewhereSpreads = 3.0;
/// Measured: 0 to 0.0001 at the true pose; 0.002 to 0.026 where shelves, posts or racks fit to their
/// neighbours. What was moved between the recordings is up to 0.15 (kRoomMinAgreeing).
inline constexpr double kRoomNearlyAsWell = 0.01;
inline constexpr double kRoomAsWell = 0.002;
/// Shares of the allowed error of the start within which the start decides for a pose, and within which a
/// rival is as likely: the start is a rough measurement.
inline constexpr double kRoomStartSlack = 1.05, kRoomStartMargin = 1.25;

}  // namespace abstand::tracking
