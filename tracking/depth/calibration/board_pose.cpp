// Camera pose from chessboards at known poses.
#include "tracking/depth/calibration/board_pose.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.hpp"
#include "tracking/depth/calibration/pose_spread.hpp"
#include "tracking/depth/calibration/refuse.hpp"

namespace abstand::tracking {
namespace {

constexpr double kMaxOff = 1.5;     // pixels
constexpr double kClearer = 1.25;   // ratio of errors above which the better pose is unambiguous
constexpr double kSamePose = 1e-3;  // rad
constexpr int kMaxSteps = 50;
constexpr double kSmallStep = 1e-11;
constexpr double kDelta = 1e-6;  // m and rad, step of numerical derivatives

struct Corner {
  Eigen::Vector2d pixel;
  Vector3d p_W;
};

std::vector<Corner> allCorners(const Chessboard& board, std::span<const PlacedBoard> views) {
  std::vector<Corner> all;
  for (const PlacedBoard& view : views)
    for (std::size_t i = 0; i < view.corners.size(); ++i)
      all.push_back({view.corners[i], view.X_WO * board.corner(i)});
  return all;
}

Vector3d middleOf(const std::vector<Corner>& corners) {
  Vector3d sum = Vector3d::Zero();
  for (const Corner& c : corners) sum += c.p_W;
  return sum / static_cast<double>(corners.size());
}

/// Reprojection error of a corner in pixels; nullopt if it is behind the camera.
std::optional<Eigen::Vector2d> off(const DepthCamera& camera, const Transform& X_CW, const Corner& corner) {
  const Vector3d p_C = X_CW * corner.p_W;
  if (!(p_C.z() > 0.0)) return std::nullopt;
  return camera.pixelOf(p_C) - corner.pixel;
}

/// Normal equations: sum r^2, J^T J and J^T r.
struct Normal {
  double squares{0.0};
  Matrix6d JTJ{Matrix6d::Zero()};
  Vector6d JTr{Vector6d::Zero()};
};

std::optional<Normal> normalOf(const DepthCamera& camera, const std::vector<Corner>& corners,
                               const Transform& X_WC, const Vector3d& pivot) {
  std::array<Transform, 12> beside;
  for (int k = 0; k < 6; ++k)
    for (int side = 0; side < 2; ++side) {
      const Vector6d step = (side ? -kDelta : kDelta) * Vector6d::Unit(k);
      beside[static_cast<std::size_t>(2 * k + side)] = movedAbout(pivot, X_WC, step).inverse();
    }
  const Transform X_CW = X_WC.inverse();
  Normal normal;
  for (const Corner& corner : corners) {
    const auto r = off(camera, X_CW, corner);
    if (!r) return std::nullopt;
    Eigen::Matrix<double, 2, 6> J;
    for (int k = 0; k < 6; ++k) {
      const auto more = off(camera, beside[static_cast<std::size_t>(2 * k)], corner);
      const auto less = off(camera, beside[static_cast<std::size_t>(2 * k + 1)], corner);
      if (!more || !less) return std::nullopt;
      J.col(k) = (*more - *less) / (2.0 * kDelta);
    }
    normal.squares += r->squaredNorm();
    normal.JTJ += J.transpose() * J;
    normal.JTr += J.transpose() * *r;
  }
  return normal;
}

struct Solution {
  Transform X_WC;
  Normal normal;
};

std::optional<Solution> refined(const DepthCamera& camera, const std::vector<Corner>& corners,
                                const Transform& start) {
  const Vector3d pivot = middleOf(corners);
  Solution s{start, {}};
  for (int i = 0; i < kMaxSteps; ++i) {
    const auto normal = normalOf(camera, corners, s.X_WC, pivot);
    if (!normal) return std::nullopt;
    s.normal = *normal;
    const Vector6d step = -normal->JTJ.ldlt().solve(normal->JTr);
    if (!step.allFinite()) return std::nullopt;
    if (step.norm() < kSmallStep) break;
    s.X_WC = movedAbout(pivot, s.X_WC, step);
  }
  return s;
}

double angleBetween(const Transform& a, const Transform& b) {
  return Quaterniond(a.linear()).angularDistance(Quaterniond(b.linear()));
}

}  // namespace

BoardFit fitBoardPose(const DepthCamera& camera, const Chessboard& board,
                      std::span<const PlacedBoard> views) {
  ABSTAND_CHECK(!views.empty());
  const bool has_start = !camera.X_WC.matrix().isIdentity(0.0);
  if (board.isSameTurned() && !has_start)
    throw UsageError("--squares: found a board with ambiguous orientation (" + std::to_string(board.columns) +
                     " x " + std::to_string(board.rows) +
                     "), expected one even and one odd side, or a camera file with a rough T_WC");
  std::vector<PlacedBoard> placed(views.begin(), views.end());
  std::vector<Transform> starts;
  for (PlacedBoard& view : placed) {
    std::vector<Transform> poses;
    for (const Transform& X_CO : posesOfBoard(camera, board, view.corners))
      poses.push_back(view.X_WO * X_CO.inverse());
    if (board.isSameTurned() && !poses.empty()) {
      BoardCorners turned(view.corners.rbegin(), view.corners.rend());
      std::vector<Transform> others;
      for (const Transform& X_CO : posesOfBoard(camera, board, turned))
        others.push_back(view.X_WO * X_CO.inverse());
      if (!others.empty() &&
          angleBetween(others.front(), camera.X_WC) < angleBetween(poses.front(), camera.X_WC)) {
        poses = others;
        view.corners = turned;
      }
    }
    starts.insert(starts.end(), poses.begin(), poses.end());
  }
  const std::vector<Corner> corners = allCorners(board, placed);
  std::vector<Solution> solutions;
  for (const Transform& start : starts)
    if (const auto s = refined(camera, corners, start)) solutions.push_back(*s);
  if (solutions.empty()) throw UsageError("--chessboard: found no camera pose that fits the corners");
  std::stable_sort(solutions.begin(), solutions.end(),
                   [](const Solution& a, const Solution& b) { return a.normal.squares < b.normal.squares; });
  const double n = static_cast<double>(corners.size());
  const auto rms = [n](const Solution& s) { return std::sqrt(s.normal.squares / n); };
  Solution best = solutions.front();
  for (const Solution& s : solutions) {
    if (angleBetween(s.X_WC, solutions.front().X_WC) < kSamePose ||
        rms(s) > kClearer * rms(solutions.front()))
      continue;
    if (!has_start)
      refuse(
          "--chessboard: found two poses that fit the corners equally well (%.2f and %.2f pixels), expected "
          "a "
          "larger or nearer board, or a camera file with a rough T_WC",
          rms(solutions.front()), rms(s));
    if (angleBetween(s.X_WC, camera.X_WC) < angleBetween(best.X_WC, camera.X_WC)) best = s;
  }
  BoardFit fit;
  fit.X_WC = best.X_WC;
  fit.rms = rms(best);
  if (!(fit.rms <= kMaxOff))
    refuse(
        "--chessboard: found a reprojection error of %.1f pixels, expected at most %.1f: the intrinsics or "
        "the "
        "placements of the boards are wrong",
        fit.rms, kMaxOff);
  const Transform X_CW = best.X_WC.inverse();
  std::size_t i = 0;
  for (std::size_t k = 0; k < placed.size(); ++k)
    for (std::size_t j = 0; j < placed[k].corners.size(); ++j, ++i) {
      fit.depth += (X_CW * corners[i].p_W).z() / n;
      const double distance = off(camera, X_CW, corners[i])->norm();
      if (distance < fit.worst) continue;
      fit.worst = distance;
      fit.worst_view = k;
    }
  const double sigma2 = best.normal.squares / (2.0 * n - 6.0);
  const double across = std::sqrt(sigma2) * fit.depth / std::sqrt(camera.fx * camera.fy);
  const Matrix6d covariance = sigma2 * best.normal.JTJ.inverse();
  const Vector3d to_camera = best.X_WC.translation() - middleOf(corners);
  fit.spread = std::hypot(across, spreadWithin(covariance, to_camera));
  return fit;
}

}  // namespace abstand::tracking
