#include "tests/core/scene/crowd.hpp"

#include <bit>
#include <cstdint>
#include <map>

#include "tests/support/random_pose.hpp"

namespace abstand::testing {
namespace {

bool same(double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }
bool same(const Vector3d& x, const Vector3d& y) {
  return same(x.x(), y.x()) && same(x.y(), y.y()) && same(x.z(), y.z());
}

}  // namespace

std::shared_ptr<const structure::HapticStructure> ball(int cm, const Vector3d& com) {
  static std::map<int, std::shared_ptr<const structure::HapticStructure>> built;
  auto& one = built[cm];
  if (!one)
    one = structure::buildHapticStructure("ball", geometry::makeSurface(geometry::Sphere{unit::cm(cm)}),
                                          {.voxel_size = 0.04, .point_spacing = 0.04});
  auto moved = std::make_shared<structure::HapticStructure>(*one);
  moved->com = com;
  return moved;
}

Transform at(double x, double y, double z) {
  Transform X = Transform::Identity();
  X.translation() = Vector3d(x, y, z);
  return X;
}

scene::Scene crowd(int n) {
  scene::Scene scene;
  for (int i = 0; i < n; ++i)
    scene.addObject({"ball" + std::to_string(i), "objects", ball(20 + i, Vector3d(0.01 * i, 0, 0)), 0.01});
  for (std::uint32_t a = 0; a < static_cast<std::uint32_t>(n); ++a)
    for (std::uint32_t b = a + 1; b < static_cast<std::uint32_t>(n); ++b)
      scene.addPair(ObjectId(a), ObjectId(b));
  return scene;
}

void scatter(scene::Scene& scene, int frame, double reach) {
  for (std::uint32_t i = 0; i < scene.objectCount(); ++i)
    scene.setPose(ObjectId(i), randomPose(1000u * static_cast<unsigned>(frame) + i, reach), 0.01 * frame);
}

query::PairResult queried(const scene::Scene& scene, const scene::Pair& pair) {
  const scene::Object& a = scene.object(pair.a);
  const scene::Object& b = scene.object(pair.b);
  kernels::PairScratch scratch;
  query::PairResult result;
  query::queryPair({*a.spec.structure, a.X_WB}, {*b.spec.structure, b.X_WB}, pair.options, scratch, result);
  return result;
}

bool sameBits(const query::PairResult& x, const query::PairResult& y) {
  return same(x.distance, y.distance) && same(x.bound, y.bound) && same(x.witness_a, y.witness_a) &&
         same(x.witness_b, y.witness_b) && same(x.force_a, y.force_a) && same(x.torque_a, y.torque_a) &&
         same(x.torque_b, y.torque_b) && x.contacts == y.contacts && same(x.depth, y.depth);
}

}  // namespace abstand::testing
