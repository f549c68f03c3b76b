#include "tracking/depth/people/camera_motion.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// In units of stepAt(): first most changes count, finally only those that are noise.
constexpr std::array<double, 12> kScales{16.0, 16.0, 8.0, 8.0, 4.0, 4.0, 2.0, 2.0, 1.0, 1.0, 1.0, 1.0};
constexpr double kOnePlane = 1.5;  // stepAt(): distance of a point from the line through its neighbours
constexpr double kAlong = 0.1;     // cosine: surfaces seen more nearly along them count as if seen at this
// Weight of no translation, and of no rotation at an arm of 1 m, as a share of a surface across the motion
// that fills the image: what the surfaces do not determine, as a translation along a wall, is not found in
// the noise of their normals.
constexpr double kStill = 0.01;

/// `step`: translation (m) and rotation vector (rad), in the axes of the result.
Transform movedBy(const Vector6d& step, const Transform& X_BN) {
  const Vector3d turn = step.tail<3>();
  Transform moved = Transform::Identity();
  moved.translate(Vector3d(step.head<3>()));
  if (const double angle = turn.norm(); angle > 0.0) moved.rotate(Eigen::AngleAxisd(angle, turn / angle));
  return moved * X_BN;
}

/// Depth steps along the ray of p per m along the normal.
double stepsPerMetre(const Vector3d& n, const Vector3d& p) {
  return 1.0 / (std::max(std::abs(n.dot(p)) / p.norm(), kAlong) * CameraMotionFit::stepAt(p.z()));
}

}  // namespace

CameraMotionFit::CameraMotionFit(const DepthCamera& camera, const PixelGrid& grid)
    : camera_{camera}, grid_{grid}, planes_(grid.size()) {
  rays_.reserve(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      rays_.push_back(camera.at(grid.pixelOf(column), grid.pixelOf(row), 1.0));
}

/// From the neighbours to the left and right, above and below.
void CameraMotionFit::findPlanes(std::span<const float> before) {
  for (Plane& plane : planes_) plane.is_known = false;
  const auto columns = static_cast<std::size_t>(grid_.columns);
  for (int row = 1; row + 1 < grid_.rows; ++row) {
    for (int column = 1; column + 1 < grid_.columns; ++column) {
      const std::size_t c = static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column);
      // Inverse depths are linear over the image of a plane.
      const double z = before[c];
      const auto isBetween = [&](std::size_t a, std::size_t b) {
        if (before[a] <= 0.0f || before[b] <= 0.0f) return false;
        const double middle = 0.5 / static_cast<double>(before[a]) + 0.5 / static_cast<double>(before[b]);
        return std::abs(1.0 / middle - z) < kOnePlane * stepAt(z);
      };
      if (z <= 0.0 || !isBetween(c - 1, c + 1) || !isBetween(c - columns, c + columns)) continue;
      const auto at = [&](std::size_t k) -> Vector3d { return static_cast<double>(before[k]) * rays_[k]; };
      const Vector3d n = (at(c + 1) - at(c - 1)).cross(at(c + columns) - at(c - columns));
      planes_[c] = {at(c), n.normalized(), true};
    }
  }
}

const CameraMotionFit::Plane* CameraMotionFit::planeAt(const Vector3d& p_B) const {
  if (p_B.z() <= 0.0) return nullptr;
  const double column = (camera_.fx * p_B.x() / p_B.z() + camera_.cx) / grid_.step;
  const double row = (camera_.fy * p_B.y() / p_B.z() + camera_.cy) / grid_.step;
  if (!(column >= 0.0 && column < grid_.columns && row >= 0.0 && row < grid_.rows)) return nullptr;
  const Plane& plane = planes_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
                               static_cast<std::size_t>(column)];
  return plane.is_known ? &plane : nullptr;
}

/// One Gauss-Newton step.
void CameraMotionFit::improve(std::span<const float> now, double scale, Transform& X_BN) const {
  Matrix6d JTJ = Matrix6d::Zero();
  Vector6d JTr = Vector6d::Zero();
  double still = 0.0;
  for (std::size_t c = 0; c < rays_.size(); ++c) {
    if (now[c] <= 0.0f) continue;
    const Vector3d p = X_BN * (static_cast<double>(now[c]) * rays_[c]);
    const Plane* plane = planeAt(p);
    if (!plane) continue;
    const double per_step = stepsPerMetre(plane->n, p);
    const double r = plane->n.dot(p - plane->p) * per_step;
    const double w = scale * scale / (scale * scale + r * r);
    still += kStill * w * w / (stepAt(p.z()) * stepAt(p.z()));
    Vector6d J;
    J << plane->n, p.cross(plane->n);
    J *= per_step;
    JTJ.noalias() += w * w * J * J.transpose();
    JTr.noalias() += w * w * r * J;
  }
  const Eigen::AngleAxisd turn(X_BN.linear());
  Vector6d motion;
  motion << X_BN.translation(), turn.angle() * turn.axis();
  JTJ.diagonal().array() += still;
  JTr += still * motion;
  const Vector6d step = -JTJ.ldlt().solve(JTr);
  if (step.allFinite()) X_BN = movedBy(step, X_BN);
}

CameraMotionFit::Change CameraMotionFit::changeBy(const Transform& X_BN, std::span<const float> now) const {
  Change change;
  for (std::size_t c = 0; c < rays_.size(); ++c) {
    if (now[c] <= 0.0f || !planes_[c].is_known) continue;
    const Vector3d p = static_cast<double>(now[c]) * rays_[c], moved = X_BN * p;
    change.squares += (moved - p).squaredNorm();
    ++change.cells;
    Third& third = change.thirds[grid_.thirdOfCell(c)];
    ++third.cells;
    const Plane* plane = planeAt(moved);
    if (!plane) continue;
    const double gain = changeFrom(planes_[c], p) - changeFrom(*plane, moved);
    (gain > 0.0 ? third.gained : third.lost) += std::abs(gain);
  }
  return change;
}

/// Square of the distance along the ray, in depth steps, at most 1.
double CameraMotionFit::changeFrom(const Plane& plane, const Vector3d& p_B) {
  const double r = plane.n.dot(p_B - plane.p) * stepsPerMetre(plane.n, p_B);
  return std::min(r * r, 1.0);
}

std::optional<CameraMotion> CameraMotionFit::estimate(std::span<const float> before,
                                                      std::span<const float> now) {
  findPlanes(before);
  if (!haveChanged(now)) return {};
  CameraMotion motion;
  for (const double scale : kScales) improve(now, scale, motion.X_BN);
  const Change change = changeBy(motion.X_BN, now);
  if (!change.thirds.front().isExplained() || !change.thirds.back().isExplained()) return {};
  motion.displacement = std::sqrt(change.squares / static_cast<double>(change.cells));
  return motion;
}

/// On both sides.
bool CameraMotionFit::haveChanged(std::span<const float> now) const {
  std::array<double, PixelGrid::kThirds> changes{}, cells{};
  for (std::size_t c = 0; c < rays_.size(); ++c) {
    if (now[c] <= 0.0f || !planes_[c].is_known) continue;
    const std::size_t third = grid_.thirdOfCell(c);
    changes[third] += changeFrom(planes_[c], static_cast<double>(now[c]) * rays_[c]);
    cells[third] += 1.0;
  }
  return std::min(cells.front(), cells.back()) >= kMinCells && changes.front() >= kChanged * cells.front() &&
         changes.back() >= kChanged * cells.back();
}

}  // namespace abstand::tracking
