// Camera pose from the room that a camera with known pose sees, too.
#pragma once

#include "tracking/depth/calibration/room_view.hpp"

namespace abstand::tracking {

struct RoomFit {
  Transform X_WC{Transform::Identity()};
  double rms{0.0};        ///< m, weighted, distances between the surfaces of both cameras along the normals
  std::size_t points{0};  ///< number of points used, by weight
  double shared{0.0};     ///< share of the camera's surface that the known camera sees, too
  double agreeing{0.0};   ///< share of the surface in free view of both cameras on which both agree
  double weakest{0.0};    ///< weakestConstraint() of the points
  double moved{0.0}, turned{0.0};  ///< m, rad, change from the start pose
  /// m, standard deviation along the worst axis: rms and the covariance of the pose, as for surfaces
  /// (surface_pose.hpp), and the spread of the known camera.
  double spread{0.0};
};

/// Pose of `camera` from a start camera().X_WC with an error of up to 0.2 m and 20 degrees. Generalised ICP
/// of both clouds (CloudRegistration), from the start and from rotated starts, then Gauss-Newton on the
/// distances along the normals between each point and the surface in the pixel of the other camera, for
/// points with consistent normals (projective association; Blais, Levine 1995), with weights of the depth
/// noise and of Geman-McClure. Throws UsageError if fewer than 1,000 points are seen by both cameras, if they
/// agree on less than 85 % of what both see, if a degree of freedom is not determined, and if the RMS
/// distance exceeds 20 mm. Deterministic.
RoomFit fitPoseToRoom(const RoomView& known, const RoomView& camera);

}  // namespace abstand::tracking
