#include "core/math/object_motion.hpp"

namespace abstand {

Vector3d rotationBetween(const Matrix3d& R_WFrom, const Matrix3d& R_WTo) {
  // Through the quaternion, whose vector part keeps small angles at full precision.
  const Eigen::AngleAxisd turn(Quaterniond(Matrix3d(R_WTo * R_WFrom.transpose())).normalized());
  return turn.angle() * turn.axis();
}

}  // namespace abstand
