#include "core/math/turn_between.hpp"

#include <Eigen/SVD>

namespace abstand {

Quaterniond turnBetween(const Vector3d& from, const Vector3d& to) {
  return Quaterniond::FromTwoVectors(from, to);
}

}  // namespace abstand
