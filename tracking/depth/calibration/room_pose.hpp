// Camera pose from the room that a camera with known pose sees, too.
#pragma once

#include "tracking/depth/calibration/room_rows.hpp"

namespace abstand::tracking {

struct RoomFit {
  Transform X_WC{Transform::Identity()};
  double rms{0.0};        ///< m, weighted, distances between the surfaces of both cameras along the normals
  std::size_t points{0};  ///< number of matched points of both cameras
  RoomAgreement agreement{};
  double moved{0.0}, turned{0.0};  ///< m, rad, change from the start pose
  bool is_start_near{true};        ///< the change is within the error that a start may have
  /// m, to the nearest other pose that explains the room nearly as well, of which the start excludes all;
  /// infinite: none was found.
  double rival{kInfinity};
  /// m, standard deviation along the worst axis: rms and the covariance of the pose, as for surfaces
  /// (surface_pose.hpp), and the spread of the known camera. Where few surfaces determine a degree of freedom
  /// (RoomAgreement::weakest below 0.015), rms / sqrt(weakest) instead of rms: the largest error that
  /// systematic errors of that RMS distance can cause.
  double spread{0.0};
};

/// Pose of `camera` from a start camera().X_WC with an error of up to 0.2 m and 20 degrees. All poses in
/// which the room fits are searched (searchRoom()), since parts of a room may be repeated, and one is chosen
/// by what each predicts and the cameras do not see (chooseRoomPose()). Gauss-Newton on the distances along
/// the normals between each point and the surface in the pixel of the other camera, for points with
/// consistent normals (projective association; Blais, Levine 1995), with weights of the depth noise and of
/// Geman-McClure. Throws UsageError if fewer than 1,000 points are seen by both cameras, if they agree on
/// less than 85 % of what both see, if a degree of freedom is not determined, if the RMS distance exceeds 20
/// mm, if the spread without that of the known camera exceeds 0.1 m, and if several poses explain the room
/// and the start does not decide. Deterministic.
RoomFit fitPoseToRoom(const RoomView& known, const RoomView& camera);

}  // namespace abstand::tracking
