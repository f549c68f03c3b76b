// Poses of the rig within its limits, with a fixed seed.
#pragma once

#include <random>

#include "tracking/body/body_solver.hpp"

namespace abstand::testing {

/// `wildness` 0: standing; 1: any freedom anywhere within half of its range.
inline tracking::RigPose randomRigPose(const tracking::BodyRig& rig, std::uint64_t seed, double wildness) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double least, double most) {
    return least + (most - least) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  tracking::RigPose pose;
  tracking::BodySolver::Vector d;
  for (int c = 0; c < tracking::kRigDof; ++c) d(c) = wildness * uniform(-0.6, 0.6);
  d.segment<3>(3) = Vector3d(0.2 * d(3), 0.2 * d(4), wildness * uniform(-3.0, 3.0));
  for (std::size_t i = 1; i < tracking::kRigSegments; ++i) {
    const tracking::RigPart& part = rig.parts[i];
    if (part.joint != tracking::RigJoint::kHinges) continue;
    for (int k = 0; k < part.freedoms; ++k) {
      const auto a = static_cast<std::size_t>(k);
      d(part.column + k) = wildness * uniform(std::max(part.lower[a], -0.2), 0.7 * part.upper[a]);
    }
  }
  tracking::advance(rig, d, pose);
  return pose;
}

}  // namespace abstand::testing
