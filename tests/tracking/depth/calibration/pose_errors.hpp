// Errors of camera poses.
#pragma once

#include "core/math/random.hpp"
#include "core/math/transform.hpp"

namespace abstand::testing {

/// rad
inline double angleBetween(const Transform& a, const Transform& b) {
  return Quaterniond(a.linear()).angularDistance(Quaterniond(b.linear()));
}

/// Wrong by exactly so much (m, rad), to a side that the seed says.
inline Transform wrong(const Transform& X_WC, double move, double turn, std::uint64_t seed) {
  Random random(seed, 0);
  const Vector3d to = random.direction(), about = random.direction();
  Transform X = X_WC;
  X.translation() += move * to;
  X.linear() = X_WC.linear() * Eigen::AngleAxisd(turn, about).toRotationMatrix();
  return X;
}

}  // namespace abstand::testing
