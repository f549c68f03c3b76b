// Poses of bodies.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace abstand {

/// X_WB maps points of B into W: p_W = X_WB * p_B. SI units (m), right-handed, world z up. Unaligned, so that
/// programs with other vector instructions than the library have the same memory layout. Converts implicitly
/// from and to Eigen::Isometry3d.
using Pose = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

}  // namespace abstand
