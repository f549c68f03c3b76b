// Camera pose from chessboards at known poses.
#pragma once

#include "tracking/depth/calibration/chessboard.hpp"

namespace abstand::tracking {

/// A detected board and its pose.
struct PlacedBoard {
  BoardCorners corners;
  Transform X_WO{Transform::Identity()};
};

struct BoardFit {
  Transform X_WC{Transform::Identity()};
  double rms{0.0};            ///< pixels, reprojection error
  double worst{0.0};          ///< pixels
  std::size_t worst_view{0};  ///< counted from 0
  double depth{0.0};          ///< m, mean over the corners
  /// m, standard deviation along the worst axis of the camera's position, and of points as far from the
  /// boards, 1 m at least; sum of two variances.
  /// Residuals: sigma = sqrt(sum r^2 / (2 n - 6)) pixels for n corners and 6 dof gives sigma depth / f across
  /// the rays; not divided by sqrt(n), as a bent board and wrong lens parameters do not average out.
  /// Covariance sigma^2 (J^T J)^-1 of the pose, by spreadWithin(): a small board far away leaves the angles
  /// uncertain.
  double spread{0.0};
};

/// Least-squares pose by reprojection error (Gauss-Newton from posesOfBoard()). For a board with half-turn
/// symmetry, the orientation nearer to camera.X_WC is used. Throws UsageError if that is needed but not given
/// (the identity), if two poses explain the corners equally well and it is not given, and if corners are more
/// than 1.5 pixels off, which is not noise.
BoardFit fitBoardPose(const DepthCamera& camera, const Chessboard& board, std::span<const PlacedBoard> views);

}  // namespace abstand::tracking
