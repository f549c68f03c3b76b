// Pictures of a chessboard whose pose is known.
#pragma once

#include "tracking/depth/calibration/chessboard.hpp"

namespace abstand::testing {

struct BoardPictureOptions {
  int samples{3};     ///< along a side of each pixel
  double noise{2.0};  ///< levels of grey, standard deviation
  std::uint64_t seed{1};
};

/// The board lies at X_WO with a white rim of one square, on grey; camera.X_WC and its distortion count.
tracking::GreyImage pictureOf(const tracking::DepthCamera& camera, const tracking::Chessboard& board,
                              const Transform& X_WO, const BoardPictureOptions& options = {});

/// A camera of 640 x 480 that looks at the middle of a board at X_WO, from `distance` (m), `lean` (rad) off
/// the board's normal towards `side` (rad about it), turned by `roll` (rad) about its own axis.
tracking::DepthCamera cameraBefore(const tracking::Chessboard& board, const Transform& X_WO, double distance,
                                   double lean, double side, double roll);

}  // namespace abstand::testing
