#include "tests/core/scene/drift.hpp"

#include <cmath>

#include "tests/support/random_pose.hpp"

namespace abstand::testing {

scene::Scene longBodies() {
  static const auto rod =
      structure::buildHapticStructure("rod", geometry::makeSurface(geometry::Capsule{0.03, 0.6}),
                                      {.voxel_size = 0.02, .point_spacing = 0.02});
  static const auto box =
      structure::buildHapticStructure("box", geometry::makeSurface(geometry::Cuboid{{0.1, 0.2, 0.5}}),
                                      {.voxel_size = 0.02, .point_spacing = 0.02});
  scene::Scene scene;
  for (std::uint32_t i = 0; i < 9; ++i)
    scene.addObject({"body" + std::to_string(i), "objects", i % 2 ? rod : box, 0.01 * (i % 3)});
  for (std::uint32_t a = 0; a < 9; ++a)
    for (std::uint32_t b = a + 1; b < 9; ++b) scene.addPair(ObjectId(a), ObjectId(b));
  return scene;
}

Drift::Drift(scene::Scene& scene) : scene_(scene) {
  for (std::uint32_t i = 0; i < scene.objectCount(); ++i) X_.push_back(randomPose(i + 77, 1.5));
}

void Drift::frame(int number) {
  for (std::uint32_t i = 0; i < X_.size(); ++i) {
    const std::uint64_t seed = 1000u * static_cast<unsigned>(number) + i;
    if (i % 3 == 0 && number % 40 < 20) continue;
    Transform& X = X_[i];
    if (randomUnit(seed, 1) < 0.002) X = randomPose(seed, 1.5);
    // Drawn back to the middle.
    const Vector3d heading(std::sin(0.01 * number + i), std::cos(0.013 * number + 2 * i), std::sin(0.7 * i));
    X.translation() += 0.003 * heading - 0.001 * X.translation();
    X.linear() = Eigen::AngleAxisd(0.02 * randomUnit(seed, 2), heading.normalized()) * X.linear();
    X.linear() = Quaterniond(X.linear()).normalized().toRotationMatrix();
    scene_.setPose(ObjectId(i), X, 0.001 * number);
  }
}

}  // namespace abstand::testing
