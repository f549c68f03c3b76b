#include "tracking/depth/calibration/pose_from_points.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {
namespace {

constexpr char kPointsHeader[] = "cx,cy,cz,wx,wy,wz";
constexpr double kMaxPointDistance = 1e3;  // m
// Smallest extent of the points across a line, as a share of their longest extent.
constexpr double kOffLine = 0.02;

/// Parses the six numbers of a line.
MatchedPoint pointOf(std::string_view line, const std::string& file, int number) {
  Cells cells(line, file, number);
  std::string_view cell;
  std::array<double, 6> v{};
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (!cells.next(cell))  // the position after one more comma
      throw ParseError({file, number, static_cast<int>(line.size()) + 2},
                       "found " + std::to_string(k) + " numbers, expected 6: " + kPointsHeader);
    const auto value = parseDouble(cell);
    if (!value || !(std::abs(*value) <= kMaxPointDistance))
      throw ParseError(cells.pos(),
                       "found " + text::inQuotes(cell) + ", expected a number of metres, at most 1000");
    v[k] = *value;
  }
  if (cells.next(cell))
    throw ParseError(cells.pos(), std::string("found more than 6 numbers, expected 6: ") + kPointsHeader);
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

std::string_view withoutBlanksBehind(std::string_view line) {
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

/// Singular value decomposition of a sum of products of coordinates. Those of many columns take ten times as
/// long to compile.
using Decomposition = Eigen::JacobiSVD<Matrix3d>;

bool onALine(const Eigen::Matrix3Xd& centred) {
  const Decomposition svd(centred * centred.transpose());
  const Vector3d& squares = svd.singularValues();
  return !(squares[1] > kOffLine * kOffLine * squares[0]);
}

/// Rotation of least squares that takes the columns of `from` to those of `to`, both centred (Kabsch 1976).
Matrix3d rotationOnto(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
  const Decomposition svd(to * from.transpose(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

std::vector<MatchedPoint> readMatchedPoints(const std::string& text, const std::string& file) {
  std::vector<MatchedPoint> points;
  Lines lines(text);
  std::string_view line;
  if (!lines.next(line))
    throw ParseError({file, 1, 1}, std::string("found nothing, expected the header ") + kPointsHeader);
  if (withoutBlanksBehind(line) != kPointsHeader)
    throw ParseError({file, 1, 1},
                     "found " + text::inQuotes(line) + ", expected the header " + kPointsHeader);
  while (lines.next(line))
    if (const std::string_view row = withoutBlanksBehind(line); !row.empty())
      points.push_back(pointOf(row, file, lines.number()));
  return points;
}

PoseFit fitPose(std::span<const MatchedPoint> points) {
  if (points.size() < 3)
    throw UsageError("found " + std::to_string(points.size()) + " matched points, expected 3 or more");
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::Matrix3Xd camera(3, n), world(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    camera.col(i) = points[static_cast<std::size_t>(i)].p_C;
    world.col(i) = points[static_cast<std::size_t>(i)].p_W;
  }
  const Vector3d mean_camera = camera.rowwise().mean(), mean_world = world.rowwise().mean();
  camera.colwise() -= mean_camera;
  world.colwise() -= mean_world;
  if (onALine(camera) || onALine(world))
    throw UsageError("found collinear points, expected some off the line");
  PoseFit fit;
  fit.X_WC.linear() = rotationOnto(camera, world);
  fit.X_WC.translation() = mean_world - fit.X_WC.linear() * mean_camera;
  fit.X_WC.makeAffine();
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double off = (fit.X_WC * points[i].p_C - points[i].p_W).norm();
    squares += off * off;
    if (off < fit.worst) continue;
    fit.worst = off;
    fit.worst_point = i;
  }
  fit.rms = std::sqrt(squares / static_cast<double>(points.size()));
  const double variance = squares / static_cast<double>(3 * points.size() - 6);
  fit.sigma = std::sqrt(variance);
  fit.middle = mean_world;
  const Matrix3d moments = world * world.transpose();
  fit.covariance.setZero();
  fit.covariance.topLeftCorner<3, 3>().diagonal().setConstant(variance / static_cast<double>(n));
  fit.covariance.bottomRightCorner<3, 3>() =
      variance * (moments.trace() * Matrix3d::Identity() - moments).inverse();
  fit.spread = std::hypot(fit.sigma, spreadWithin(fit.covariance, fit.X_WC.translation() - fit.middle));
  return fit;
}

}  // namespace abstand::tracking
