#include "tracking/depth/pose_from_points.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand {
namespace {

constexpr char kHeader[] = "cx,cy,cz,wx,wy,wz";
constexpr double kFarthest = 1e3;  // m
// Share of the longest extent that points have to leave a line by.
constexpr double kOffLine = 0.02;

std::string withoutReturn(std::string line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
  return line;
}

/// The six numbers of a line.
MatchedPoint pointOf(const std::string& line, const std::string& file, int number) {
  std::array<double, 6> v{};
  std::size_t at = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    const SourcePos pos{file, number, static_cast<int>(at) + 1};
    if (at > line.size())
      throw ParseError(pos, "found " + std::to_string(k) + " numbers, expected 6: " + kHeader);
    const std::size_t end = std::min(line.find(',', at), line.size());
    const std::string word = line.substr(at, end - at);
    const auto value = parseDouble(word);
    if (!value || !(std::abs(*value) <= kFarthest))
      throw ParseError(pos, "found '" + word + "', expected a number of metres, at most 1000");
    v[k] = *value;
    at = end + 1;
  }
  if (at <= line.size())
    throw ParseError({file, number, static_cast<int>(at) + 1},
                     "found more than 6 numbers, expected 6: " + std::string(kHeader));
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

bool onALine(const Eigen::Matrix3Xd& points) {
  const Vector3d middle = points.rowwise().mean();
  const Eigen::JacobiSVD<Eigen::Matrix3Xd> svd(points.colwise() - middle);
  const auto& extents = svd.singularValues();
  return !(extents[1] > kOffLine * extents[0]);
}

}  // namespace

std::vector<MatchedPoint> readMatchedPoints(const std::string& text, const std::string& file) {
  std::vector<MatchedPoint> points;
  int number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = withoutReturn(text.substr(at, end - at));
    at = end + 1;
    ++number;
    if (number == 1) {
      if (line != kHeader)
        throw ParseError({file, 1, 1}, "found '" + line.substr(0, 60) + "', expected the header " + kHeader);
    } else if (!line.empty()) {
      points.push_back(pointOf(line, file, number));
    }
  }
  if (number == 0)
    throw ParseError({file, 1, 1}, "found nothing, expected the header " + std::string(kHeader));
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
  if (onALine(camera) || onALine(world))
    throw UsageError(
        "found matched points on a line, expected some beside it: the camera could turn about it");
  PoseFit fit;
  fit.X_WC.matrix() = Eigen::umeyama(camera, world, false);
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double off = (fit.X_WC * points[i].p_C - points[i].p_W).norm();
    squares += off * off;
    if (off < fit.worst) continue;
    fit.worst = off;
    fit.worst_point = i;
  }
  fit.rms = std::sqrt(squares / static_cast<double>(points.size()));
  fit.spread = std::sqrt(squares / static_cast<double>(3 * points.size() - 6));
  return fit;
}

}  // namespace abstand
