// A pose of a camera, and how well it explains the room that two cameras see.
#pragma once

#include "tracking/depth/calibration/room_rows.hpp"

namespace abstand::tracking {

struct RoomCandidate {
  Transform X_WC{Transform::Identity()};
  double cost{kInfinity};  ///< m, RoomRows::cost()
  double rms{0.0};         ///< m, weighted, of the matched points of both cameras along the normals
  std::size_t points{0};   ///< number of matched points
  RoomAgreement agreement{};
  double spread{0.0};  ///< m, RoomFit::spread without that of the known camera
};

/// With all points.
RoomCandidate judgeRoomPose(const RoomRows& rows, const Transform& X_WC);

/// Fewest matched points, smallest share on which the cameras agree, largest RMS distance (m).
inline constexpr std::size_t kRoomMinPoints = 1000;
inline constexpr double kRoomMinAgreeing = 0.85, kRoomMaxRms = 0.02;
/// Smallest RoomAgreement::weakest. Measured: a floor, a wall or both up to 0.0003 also in single images; a
/// floor, a wall and two boxes 0.0028.
inline constexpr double kRoomMinConstraint = 0.001;

/// RoomAgreement::weakest below which the errors of the few surfaces that determine a direction count as
/// systematic. Measured: rooms with a floor and two walls 0.026 and more, with errors below `spread`; posts
/// that alone determine a direction 0.004, with an error of 5 mm, nine times the spread without this.
inline constexpr double kRoomWeak = 0.015;

/// Whether a pose is within these limits.
bool isAcceptable(const RoomCandidate& candidate);

}  // namespace abstand::tracking
