// Chessboard detection in images. Wraps OpenCV's calibration.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/formats/grey_png.hpp"

namespace abstand::tracking {

/// A printed board. Its frame O: the origin is the inner corner next to the dark corner square, x along the
/// columns, y along the rows, z towards the viewer.
struct Chessboard {
  static constexpr int kMinSquares = 4, kMaxSquares = 40;

  int columns{0}, rows{0};  ///< squares along x and along y
  double square{0.0};       ///< m, its side

  std::size_t corners() const { return static_cast<std::size_t>((columns - 1) * (rows - 1)); }
  /// Inner corner i, counted along x first.
  Vector3d corner(std::size_t i) const {
    const auto across = static_cast<std::size_t>(columns - 1);
    return {square * static_cast<double>(i % across), square * static_cast<double>(i / across), 0.0};
  }
  /// True if the board is symmetric under half a turn: its sides are both even, or both odd.
  bool isSameTurned() const { return (columns + rows) % 2 == 0; }
};

/// Pixel positions of the inner corners, accurate to 0.1 pixel or better.
using BoardCorners = std::vector<Eigen::Vector2d>;

/// Corners in the order of Chessboard::corner(); for a symmetric board from either end. nullopt if the whole
/// board is not visible.
std::optional<BoardCorners> findChessboard(const GreyImage& image, const Chessboard& board);

/// The two poses X_CO of a plane that explain its corners (Collins, Bartoli, IJCV 2014), the better one
/// first; one if they are equal, none if there is none.
std::vector<Transform> posesOfBoard(const DepthCamera& camera, const Chessboard& board,
                                    const BoardCorners& corners);

struct IntrinsicsFit {
  DepthCamera camera;        ///< without a pose; k3 is 0
  double rms{0.0};           ///< pixels, reprojection error
  double focal_spread{0.0};  ///< standard deviation of the focal lengths, relative; the larger one
};

/// Focal lengths, principal point and distortion k1, k2, p1, p2 from views of one board in different poses
/// (Zhang, PAMI 2000). Throws UsageError for fewer than kMinViews, and for views that do not determine the
/// focal length, e.g. if the board always faces the camera.
IntrinsicsFit fitIntrinsics(const Chessboard& board, std::span<const BoardCorners> views, int width,
                            int height);
inline constexpr std::size_t kMinViews = 5;

}  // namespace abstand::tracking
