// Where a camera stands, from chessboards at known places.
#pragma once

#include "tracking/depth/calibration/chessboard.hpp"

namespace abstand::tracking {

/// A board that was seen, and where it lies.
struct PlacedBoard {
  BoardCorners corners;
  Transform X_WO{Transform::Identity()};
};

struct BoardFit {
  Transform X_WC{Transform::Identity()};
  double rms{0.0};            ///< pixels, of the distances that are left
  double worst{0.0};          ///< pixels
  std::size_t worst_view{0};  ///< counted from 0
  double depth{0.0};          ///< m, mean of the corners
  /// m, standard deviation of an axis of a point that the camera sees. Two parts, added as squares:
  /// - what is left, sigma = sqrt(sum r^2 / (2 n - 6)) pixels of n corners and 6 freedoms, is sigma depth / f
  ///   across the rays. It is not divided by sqrt(n): a bent board and a wrong lens do not average out.
  /// - the covariance sigma^2 (J^T J)^-1 of the pose, by spreadAt() kUsedWithin of the boards' middle: a
  /// small
  ///   board far away leaves the angles open.
  double spread{0.0};
};

/// The pose with the least squares in the image (Gauss-Newton from posesOfBoard()). A board that is the same
/// turned is taken the way round that is nearer to camera.X_WC. Throws UsageError where that is not given
/// (the identity), where two poses explain the corners alike and it is not given, and where the corners are
/// more than 1.5 pixels off, which is no noise.
BoardFit fitBoardPose(const DepthCamera& camera, const Chessboard& board, std::span<const PlacedBoard> views);

}  // namespace abstand::tracking
