// Poses of bodies.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace abstand {

/// X_WB takes points of B into W: p_W = X_WB * p_B. SI units (m), right-handed, world z up. Unaligned, so
/// that programs with other vector instructions than the library's have the same layout; made of an
/// Eigen::Isometry3d without a word, and the other way round.
using Pose = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

}  // namespace abstand
