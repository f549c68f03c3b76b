// Chessboard detection in images. Wraps OpenCV's calibration.
#include "tracking/depth/calibration/chessboard.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr double kMaxFocalSpread = 0.02;
constexpr double kMinLean = 15.0;  // degrees, smallest required angle between the boards of two views

using Corners = std::vector<cv::Point2f>;

cv::Mat matrixOf(const DepthCamera& c) {
  return (cv::Mat_<double>(3, 3) << c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0);
}

std::vector<double> distortionOf(const DepthCamera& c) {
  return {c.distortion.data(), c.distortion.data() + c.distortion.size()};
}

Matrix3d turnOf(const cv::Mat& m) {
  const Vector3d turn(m.at<double>(0), m.at<double>(1), m.at<double>(2));
  if (!(turn.norm() > 0.0)) return Matrix3d::Identity();
  return Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
}

/// Largest angle (rad) between the normals of two boards.
double maxTilt(const std::vector<cv::Mat>& turns) {
  double smallest = 1.0;
  for (const cv::Mat& a : turns)
    for (const cv::Mat& b : turns) smallest = std::min(smallest, turnOf(a).col(2).dot(turnOf(b).col(2)));
  return std::acos(std::clamp(smallest, -1.0, 1.0));
}

std::vector<cv::Point3f> cornersOf(const Chessboard& board) {
  std::vector<cv::Point3f> points;
  for (std::size_t i = 0; i < board.corners(); ++i) {
    const Vector3f p = board.corner(i).cast<float>();
    points.emplace_back(p.x(), p.y(), p.z());
  }
  return points;
}

Corners toCv(const BoardCorners& corners) {
  Corners out;
  for (const Eigen::Vector2d& p : corners)
    out.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  return out;
}

/// Checks that the squares alternate between dark and light, including the outermost ones; rejects a grid
/// that is shifted by a square.
struct Colours {
  bool alternate{false};
  bool origin_is_light{false};  ///< colour of square (0, 0)
};

/// Pixel at the centre of a square; for border squares by extrapolation of the neighbours' sides.
Eigen::Vector2d middleOf(const Chessboard& board, const BoardCorners& corners, int column, int row) {
  const int across = board.columns - 1, along = board.rows - 1;
  const int c = std::clamp(column - 1, 0, across - 2), r = std::clamp(row - 1, 0, along - 2);
  const double x = column - 0.5 - c, y = row - 0.5 - r;
  const auto i = static_cast<std::size_t>(r * across + c), up = i + static_cast<std::size_t>(across);
  return (1.0 - y) * ((1.0 - x) * corners[i] + x * corners[i + 1]) +
         y * ((1.0 - x) * corners[up] + x * corners[up + 1]);
}

Colours coloursOf(const GreyImage& image, const Chessboard& board, const BoardCorners& corners) {
  constexpr double kMinRight = 0.95;  // share of the squares; reflections may cover some
  std::vector<double> level[2];       // brightness of squares of the origin's colour, and of the others
  for (int r = 0; r < board.rows; ++r)
    for (int c = 0; c < board.columns; ++c) {
      const Eigen::Vector2d p = middleOf(board, corners, c, r);
      if (!(p.x() >= 0.0 && p.y() >= 0.0 && p.x() <= image.width - 1.0 && p.y() <= image.height - 1.0))
        continue;
      level[(r + c) % 2].push_back(
          image.at(static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))));
    }
  if (level[0].empty() || level[1].empty()) return {};
  const auto mean = [](const std::vector<double>& v) {
    double sum = 0.0;
    for (const double x : v) sum += x;
    return sum / static_cast<double>(v.size());
  };
  const double own = mean(level[0]), other = mean(level[1]), between = 0.5 * (own + other);
  std::size_t right = 0;
  for (const double x : level[0]) right += (x > between) == (own > other);
  for (const double x : level[1]) right += (x > between) == (other > own);
  const auto all = static_cast<double>(level[0].size() + level[1].size());
  return {static_cast<double>(right) >= kMinRight * all, own > other};
}

/// Half the side (pixels) of a window that contains only one corner, for any inclination of the board.
int windowOf(const Corners& corners, int across, int along) {
  double nearest = kInfinity;
  for (int r = 0; r < along; ++r)
    for (int c = 0; c < across; ++c) {
      const cv::Point2f& p = corners[static_cast<std::size_t>(r * across + c)];
      if (c + 1 < across)
        nearest = std::min(nearest, cv::norm(p - corners[static_cast<std::size_t>(r * across + c + 1)]));
      if (r + 1 < along)
        nearest = std::min(nearest, cv::norm(p - corners[static_cast<std::size_t>((r + 1) * across + c)]));
    }
  return std::clamp(static_cast<int>(0.35 * nearest), 2, 11);
}

}  // namespace

std::optional<BoardCorners> findChessboard(const GreyImage& image, const Chessboard& board) {
  const int across = board.columns - 1, along = board.rows - 1;
  const cv::Mat grey(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels.data()));
  // Second detector, for boards of which the first one takes the border for a row of squares.
  for (const bool by_sectors : {true, false}) {
    Corners found;
    const cv::Size size(across, along);
    const bool is_found =
        by_sectors ? cv::findChessboardCornersSB(
                         grey, size, found,
                         cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_ACCURACY)
                   : cv::findChessboardCorners(grey, size, found,
                                               cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE);
    if (!is_found || found.size() != board.corners()) return std::nullopt;
    // The detectors err by up to a quarter of a pixel in strong noise: sub-pixel refinement.
    const int window = windowOf(found, across, along);
    cv::cornerSubPix(grey, found, cv::Size(window, window), cv::Size(-1, -1),
                     cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4));
    BoardCorners corners;
    for (const cv::Point2f& p : found)
      corners.emplace_back(static_cast<double>(p.x), static_cast<double>(p.y));
    // Seen from the front, y is to the left of x, as the image's rows count downwards.
    const Eigen::Vector2d x = corners[static_cast<std::size_t>(across - 1)] - corners.front();
    const Eigen::Vector2d y = corners[static_cast<std::size_t>(across * (along - 1))] - corners.front();
    if (x.x() * y.y() - x.y() * y.x() > 0.0)
      for (int r = 0; r < along / 2; ++r)
        std::swap_ranges(corners.begin() + r * across, corners.begin() + (r + 1) * across,
                         corners.begin() + (along - 1 - r) * across);
    const Colours colours = coloursOf(image, board, corners);
    if (!colours.alternate) continue;
    if (!board.isSameTurned() && colours.origin_is_light) std::reverse(corners.begin(), corners.end());
    return corners;
  }
  return std::nullopt;
}

std::vector<Transform> posesOfBoard(const DepthCamera& camera, const Chessboard& board,
                                    const BoardCorners& corners) {
  std::vector<cv::Mat> turns, moves;
  std::vector<Transform> poses;
  try {
    cv::solvePnPGeneric(cornersOf(board), toCv(corners), matrixOf(camera), distortionOf(camera), turns, moves,
                        false, cv::SOLVEPNP_IPPE);
  } catch (const cv::Exception&) {
    return poses;
  }
  for (std::size_t i = 0; i < turns.size(); ++i) {
    Transform X = Transform::Identity();
    X.linear() = turnOf(turns[i]);
    X.translation() = Vector3d(moves[i].at<double>(0), moves[i].at<double>(1), moves[i].at<double>(2));
    if (isPose(X)) poses.push_back(X);
  }
  return poses;
}

IntrinsicsFit fitIntrinsics(const Chessboard& board, std::span<const BoardCorners> views, int width,
                            int height) {
  if (views.size() < kMinViews)
    throw UsageError("--intrinsics: found " + std::to_string(views.size()) + " images, expected " +
                     std::to_string(kMinViews) + " or more, of the board in different poses");
  const std::vector<std::vector<cv::Point3f>> points(views.size(), cornersOf(board));
  std::vector<Corners> pixels;
  for (const BoardCorners& view : views) pixels.push_back(toCv(view));
  IntrinsicsFit fit;
  cv::Mat K = cv::Mat::eye(3, 3, CV_64F), distortion, spread;
  std::vector<cv::Mat> turns, moves;
  try {
    cv::Mat spread_of_poses, residuals;
    fit.rms = cv::calibrateCamera(points, pixels, cv::Size(width, height), K, distortion, turns, moves,
                                  spread, spread_of_poses, residuals, cv::CALIB_FIX_K3);
  } catch (const cv::Exception&) {
    fit.rms = kNaN;
  }
  DepthCamera& c = fit.camera;
  if (std::isfinite(fit.rms)) {
    c.width = width;
    c.height = height;
    c.fx = K.at<double>(0, 0);
    c.fy = K.at<double>(1, 1);
    c.cx = K.at<double>(0, 2);
    c.cy = K.at<double>(1, 2);
    for (int i = 0; i < 5; ++i) c.distortion[i] = distortion.at<double>(i);
    fit.focal_spread = std::max(spread.at<double>(0) / c.fx, spread.at<double>(1) / c.fy);
  }
  // Parallel boards do not determine the focal length. The negated form also rejects NaN.
  if (!(std::isfinite(fit.rms) && fit.focal_spread <= kMaxFocalSpread &&
        maxTilt(turns) >= unit::deg(kMinLean)))
    throw UsageError(
        "--intrinsics: found boards that do not determine the focal length, expected some tilted to "
        "different "
        "sides by 20 degrees and more");
  return fit;
}

}  // namespace abstand::tracking
