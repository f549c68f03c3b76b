#include "core/scene/motion_bound.hpp"

#include <cmath>

namespace abstand::scene {
namespace {

// Some hundred rounding errors of a double: computed lengths are enlarged by this share of the values they
// are computed from.
constexpr double kRounding = 1e-14;

}  // namespace

MotionBound::MotionBound(const geometry::EnclosingSphere& sphere_B)
    : sphere_B_(sphere_B), centre_(sphere_B.centre), radius_(sphere_B.radius) {}

double MotionBound::moveTo(const Transform& X_WB) {
  const Matrix3d& R_WB = X_WB.linear();
  const Vector3d centre = X_WB * sphere_B_.centre;
  const double defect = (R_WB * R_WB.transpose() - Matrix3d::Identity()).norm();
  const double defects = defect + defect_;
  const double turn = ((R_WB - R_WB_).norm() + defects) / std::sqrt(2.0) + defects;
  const double rounding = kRounding * (centre.norm() + centre_.norm() + sphere_B_.radius);
  const double step = (centre - centre_).norm() + sphere_B_.radius * turn + rounding;
  R_WB_ = R_WB;
  centre_ = centre;
  radius_ = sphere_B_.radius * (1.0 + defect);
  defect_ = defect;
  travelled_ = std::nextafter(travelled_ + step, kInfinity);
  return step;
}

double gapOf(const MotionBound& a, const MotionBound& b) {
  const Vector3d &c = a.centre(), &d = b.centre();
  const double rounding = kRounding * (c.norm() + d.norm() + a.radius() + b.radius());
  return (d - c).norm() - a.radius() - b.radius() - rounding;
}

}  // namespace abstand::scene
