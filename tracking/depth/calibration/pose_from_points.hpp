// Where a camera stands, from points that are known both to it and in the world.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

struct MatchedPoint {
  Vector3d p_C, p_W;  ///< m: in the camera's optical frame, and in world
};

/// Reads a table: the header `cx,cy,cz,wx,wy,wz`, then a point a line, m. Throws ParseError with line and
/// column.
std::vector<MatchedPoint> readMatchedPoints(const std::string& text, const std::string& file);

struct PoseFit {
  Transform X_WC;
  double rms{0.0};             ///< m, of the distances that are left
  double worst{0.0};           ///< m
  std::size_t worst_point{0};  ///< counted from 0
  /// m, standard deviation of an axis of a point: the squares that are left over the 3 n - 6 freedoms that n
  /// points leave. Between the points the camera's pose is known at least so well.
  double spread{0.0};
};

/// The rigid motion that takes the points of the camera to those of the world with the least squares
/// (Umeyama, PAMI 1991, without scale). Throws UsageError for fewer than three points, or points on a line.
PoseFit fitPose(std::span<const MatchedPoint> points);

}  // namespace abstand::tracking
