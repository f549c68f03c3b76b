// Scenes with known force and torque in every pose.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/structure/haptic_structure.hpp"

namespace abstand::verify {

/// One pose of A relative to B (at the origin), with the volume law's force and torques for stiffness 1: on A
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
  std::size_t second_part{0};  ///< start of the second part of the path; no noise is measured across
};

/// The four scenes of Weller, Sagardia, Mainzer, Hulin, Zachmann and Preusche, A Benchmarking Suite for 6-DOF
/// Real Time Collision Response Algorithms, 2010, rebuilt with own dimensions: a ball rolling over a block, a
/// tilted cone rotating on a block, a pin moving along the wall of a hole, a block sliding along a slot's
/// floor and wall. Steps of about a tenth of a voxel of 2 mm.
std::vector<HapticScene> hapticScenes();

}  // namespace abstand::verify
