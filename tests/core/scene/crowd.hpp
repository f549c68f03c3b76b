// Scenes of coarse balls, for tests of what a scene does with its pairs.
#pragma once

#include <memory>

#include "core/scene/scene.hpp"

namespace abstand::testing {

/// A coarse ball of `cm` centimetres; its centre for torques is moved to `com`, so that moments matter.
std::shared_ptr<const HapticStructure> ball(int cm, const Vector3d& com = Vector3d::Zero());

Transform at(double x, double y = 0.0, double z = 0.0);

/// `n` balls of different sizes in a crowd, all pairs, each ball with a margin of 1 cm.
Scene crowd(int n);

/// Random poses for all, of which many touch.
void scatter(Scene& scene, int frame, double reach = 1.0);

/// What a query gives at the present poses.
PairResult queried(const Scene& scene, const Pair& pair);

/// Bit for bit, but NaN for NaN.
bool sameBits(const PairResult& x, const PairResult& y);

}  // namespace abstand::testing
