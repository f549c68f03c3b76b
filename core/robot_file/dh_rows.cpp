#include "core/robot_file/dh_rows.hpp"

#include <cmath>

namespace abstand::robot_file {
namespace {

// rad; below this angle the common normal of two lines 1 m apart is too far away to be computed accurately.
constexpr double kNearlyParallel = 1e-4;

/// The rotation about z that turns x to (x, y) or its opposite, whichever is nearer.
double turnTo(double x, double y) {
  return x < 0.0 || (x == 0.0 && y < 0.0) ? std::atan2(-y, -x) : std::atan2(y, x);
}

double sineToZ(const Vector3d& direction) { return std::hypot(direction.x(), direction.y()); }

}  // namespace

Transform transformOf(const DhRow& row) {
  return Transform(Eigen::AngleAxisd(row.alpha, Vector3d::UnitX()) * Eigen::Translation3d(row.a, 0.0, row.d) *
                   Eigen::AngleAxisd(row.theta, Vector3d::UnitZ()));
}

bool isOneRowAway(const Vector3d& point, const Vector3d& direction, const DhTolerance& tolerance) {
  return std::abs(direction.x()) <= tolerance.angle &&
         std::abs(point.y() * direction.z() - point.z() * direction.y()) <= tolerance.length;
}

DhRow rowToNormal(const Vector3d& point, const Vector3d& direction, const DhTolerance& tolerance) {
  DhRow row;
  if (isOneRowAway(point, direction, tolerance)) return row;
  const double sine = sineToZ(direction);
  if (sine > kNearlyParallel) {
    // Along z x direction: the foot of the normal on z.
    row.theta = turnTo(-direction.y(), direction.x());
    row.d =
        point.z() - direction.z() * (point.x() * direction.x() + point.y() * direction.y()) / (sine * sine);
  } else if (sine <= tolerance.angle) {
    row.theta = turnTo(point.x(), point.y());
  }
  return row;
}

std::vector<DhRow> dhRows(const Transform& X, const DhTolerance& tolerance) {
  std::vector<DhRow> rows;
  Transform rest = X;
  const auto add = [&](const DhRow& row) {
    rows.push_back(row);
    rest = transformOf(row).inverse() * rest;
  };
  const auto direction = [&] { return Vector3d(rest.linear().col(2)); };
  if (!isOneRowAway(rest.translation(), direction(), tolerance)) {
    const double sine = sineToZ(direction());
    if (sine > tolerance.angle && sine <= kNearlyParallel) {
      // Rotates x to the tilt axis, then tilts: the lines are parallel afterwards.
      const Vector3d u = direction();
      DhRow turn;
      turn.theta = turnTo(-u.y(), u.x());
      add(turn);
      DhRow tilt;
      tilt.alpha = std::atan2(-direction().y(), direction().z());
      const Transform X_tilt = transformOf(tilt);
      const Vector3d p = X_tilt.inverse() * rest.translation();
      tilt.theta = turnTo(p.x(), p.y());
      add(tilt);
    } else {
      add(rowToNormal(rest.translation(), direction(), tolerance));
    }
  }
  DhRow last;
  last.alpha = std::atan2(-direction().y(), direction().z());
  last.a = rest.translation().x();
  const Transform at_line = transformOf(last).inverse() * rest;
  last.theta = std::atan2(at_line(1, 0), at_line(0, 0));
  last.d = at_line.translation().z();
  rows.push_back(last);
  return rows;
}

}  // namespace abstand::robot_file
