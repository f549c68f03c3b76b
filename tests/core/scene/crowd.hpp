// Scenes of coarse balls, for tests of what a scene does with its pairs.
#pragma once

#include <memory>

#include "core/scene/scene.hpp"

namespace abstand::testing {

/// A coarse ball of `cm` centimetres; its centre for torques is moved to `com`, so that moments matter.
std::shared_ptr<const structure::HapticStructure> ball(int cm, const Vector3d& com = Vector3d::Zero());

Transform at(double x, double y = 0.0, double z = 0.0);

/// `n` balls of different sizes in a crowd, all pairs, each ball with a margin of 1 cm.
scene::Scene crowd(int n);

/// Random poses for all, of which many touch.
void scatter(scene::Scene& scene, int frame, double reach = 1.0);

/// What a query gives at the present poses.
query::PairResult queried(const scene::Scene& scene, const scene::Pair& pair);

/// Bit for bit, but NaN for NaN.
bool sameBits(const query::PairResult& x, const query::PairResult& y);

}  // namespace abstand::testing
