// Scenes of which force and torque are known at every pose.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/structure/haptic_structure.hpp"

namespace abstand::verify {

/// One pose of A against B (at the origin), and the volume law's force and torques for stiffness 1: on A,
/// about A's centre of mass, and on B about B's. World frame.
struct ScenePose {
  Transform X_WA{Transform::Identity()};
  Vector3d force_a{Vector3d::Zero()};
  Vector3d torque_a{Vector3d::Zero()};
  Vector3d torque_b{Vector3d::Zero()};
};

struct HapticScene {
  std::string name, what;
  std::shared_ptr<const geometry::Surface> a, b;
  std::vector<ScenePose> path;
  std::size_t second_part{0};  ///< where the path starts anew; no noise is measured across
};

/// The four scenes of Weller, Sagardia, Mainzer, Hulin, Zachmann and Preusche, A Benchmarking Suite for 6-DOF
/// Real Time Collision Response Algorithms, 2010, rebuilt with dimensions of our own: a ball rolled over a
/// block, a tilted cone turned on a block, a pin led round the wall of a hole, a block pushed along a slot's
/// floor and wall. Paths advance by about a tenth of a voxel of 2 mm.
std::vector<HapticScene> hapticScenes();

}  // namespace abstand::verify
