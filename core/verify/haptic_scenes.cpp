// Scenes with known force and torque in every pose.
#include "core/verify/haptic_scenes.hpp"

#include <cmath>

#include "core/verify/closed_contact.hpp"
#include "core/verify/meshes.hpp"

namespace abstand::verify {
namespace {

constexpr double kStep = 0.0002;  // m
constexpr int kRound = 360;       // poses of a full turn

/// Computes the torque on B from A's torque about its own centre.
void setTorqueOnB(HapticScene& scene) {
  const Vector3d com_a = scene.a->massProperties().com, com_b = scene.b->massProperties().com;
  for (ScenePose& pose : scene.path)
    pose.torque_b = -pose.torque_a - (pose.X_WA * com_a - com_b).cross(pose.force_a);
}

HapticScene ballOnBlock() {
  constexpr double kRadius = 0.03, kDepth = 0.006, kTop = 0.03;
  HapticScene scene{"ball on block",
                    "a ball of 30 mm, 6 mm deep in a block, rolls aslant over it: stiffness times the cap's "
                    "volume, straight up, no torque",
                    geometry::makeSurface(geometry::Shape{geometry::Sphere{kRadius}}),
                    geometry::makeSurface(geometry::Shape{geometry::Cuboid{{0.16, 0.16, 2.0 * kTop}}}),
                    {},
                    0};
  const Vector3d displacement = Vector3d(0.8, 0.6, 0.0), roll = Vector3d(-0.6, 0.8, 0.0);
  for (double s = -0.025; s <= 0.025; s += kStep) {
    ScenePose pose;
    pose.X_WA.linear() = Eigen::AngleAxisd(s / kRadius, roll).toRotationMatrix();
    pose.X_WA.translation() = s * displacement + (kTop + kRadius - kDepth) * Vector3d::UnitZ();
    pose.force_a = capVolume(kRadius, kDepth) * Vector3d::UnitZ();
    scene.path.push_back(pose);
  }
  return scene;
}

HapticScene coneOnBlock() {
  constexpr double kRadius = 0.03, kHeight = 0.06, kDepth = 0.012, kTop = 0.03;
  constexpr double kTilt = 0.35;  // rad
  // Its tip at the origin, pointing down.
  std::vector<std::pair<double, double>> circle;
  constexpr int kSides = 64;
  geometry::TriangleMesh cone;
  for (int i = 0; i < kSides; ++i) {
    const double a = 2.0 * kPi * i / kSides;
    cone.vertices.emplace_back(kRadius * std::cos(a), kRadius * std::sin(a), kHeight);
  }
  cone.vertices.emplace_back(0, 0, 0);
  cone.vertices.emplace_back(0, 0, kHeight);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t j = (i + 1) % kSides;
    cone.triangles.push_back({kSides, j, i});
    cone.triangles.push_back({kSides + 1, i, j});
  }
  HapticScene scene{
      "cone on block",
      "the tip of a cone, tilted by 20 degrees, 12 mm deep in a block, turns once about the vertical: "
      "the volume's weight of water, through its centroid",
      geometry::makeSurface(cone),
      geometry::makeSurface(geometry::Shape{geometry::Cuboid{{0.16, 0.16, 2.0 * kTop}}}),
      {},
      0};
  const Vector3d com = scene.a->massProperties().com;
  for (int i = 0; i < kRound; ++i) {
    const double turn = 2.0 * kPi * i / kRound;
    ScenePose pose;
    pose.X_WA.linear() =
        (Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * Eigen::AngleAxisd(kTilt, Vector3d::UnitX()))
            .toRotationMatrix();
    pose.X_WA.translation() = Vector3d(0.003 * std::cos(turn), 0.003 * std::sin(turn), -kDepth);
    const Submerged part = submerged(cone, pose.X_WA);
    pose.X_WA.translation().z() += kTop;
    pose.force_a = part.volume * Vector3d::UnitZ();
    pose.torque_a = (part.centroid + kTop * Vector3d::UnitZ() - pose.X_WA * com).cross(pose.force_a);
    scene.path.push_back(pose);
  }
  return scene;
}

HapticScene pinInHole() {
  constexpr double kPin = 0.02, kHole = 0.021, kOffset = 0.003, kLength = 0.03, kHigh = 0.008;
  constexpr int kSides = 256;  // within 1.6 um of the circle
  HapticScene scene{
      "pin in hole",
      "a pin of 20 mm in a hole of 21 mm, 3 mm off its axis, led round: radial force, on the pin no "
      "torque, on the block one across axis and force",
      geometry::makeSurface(geometry::Shape{geometry::Cylinder{kPin, kLength}}),
      geometry::makeSurface(latheMesh({{kHole, -0.03}, {0.06, -0.03}, {0.06, 0.03}, {kHole, 0.03}}, kSides)),
      {},
      0};
  const double force = pinInHoleForce(kPin, kHole, kOffset, kLength);
  for (int i = 0; i < kRound; ++i) {
    const double turn = 2.0 * kPi * i / kRound;
    const Vector3d out(std::cos(turn), std::sin(turn), 0.0);
    ScenePose pose;
    pose.X_WA.linear() = Eigen::AngleAxisd(-0.5 * turn, Vector3d::UnitZ()).toRotationMatrix();
    pose.X_WA.translation() = kOffset * out + kHigh * Vector3d::UnitZ();
    pose.force_a = -force * out;
    scene.path.push_back(pose);
  }
  return scene;
}

HapticScene blockInSlot() {
  const Vector3d size(0.06, 0.04, 0.03);
  constexpr double kClear = 0.002, kDepth = 0.003, kOver = 0.005, kSlotDepth = 0.04;
  const double half = 0.5 * size.y() + kClear;
  // The prism's slot is along z, rotated to x: its outline in y and z, floor at z = 0.
  const std::vector<std::pair<double, double>> outline{
      {-0.05, -0.03}, {0.05, -0.03}, {0.05, kSlotDepth},  {half, kSlotDepth},
      {half, 0.0},    {-half, 0.0},  {-half, kSlotDepth}, {-0.05, kSlotDepth}};
  geometry::TriangleMesh slot = prismMesh(outline, 0.16);
  for (Vector3d& v : slot.vertices) v = Vector3d(v.z(), v.x(), v.y());
  HapticScene scene{
      "block in slot",
      "a block in a slot with 2 mm to spare, pushed along 3 mm deep in the floor, then in a wall: "
      "stiffness times face times depth, straight back, no torque",
      geometry::makeSurface(geometry::Shape{geometry::Cuboid{size}}),
      geometry::makeSurface(std::move(slot)),
      {},
      0};
  for (const bool on_floor : {true, false}) {
    if (!on_floor) scene.second_part = scene.path.size();
    for (double s = -0.02; s <= 0.02; s += kStep) {
      ScenePose pose;
      const double z = 0.5 * size.z();
      if (on_floor) {
        pose.X_WA.translation() = Vector3d(s, 0.0, z - kDepth);
        pose.force_a = size.x() * size.y() * kDepth * Vector3d::UnitZ();
      } else {
        pose.X_WA.translation() = Vector3d(s, kClear + kDepth, z + kOver);
        pose.force_a = -size.x() * size.z() * kDepth * Vector3d::UnitY();
      }
      scene.path.push_back(pose);
    }
  }
  return scene;
}

}  // namespace

std::vector<HapticScene> hapticScenes() {
  std::vector<HapticScene> scenes;
  scenes.push_back(ballOnBlock());
  scenes.push_back(coneOnBlock());
  scenes.push_back(pinInHole());
  scenes.push_back(blockInSlot());
  for (HapticScene& scene : scenes) setTorqueOnB(scene);
  return scenes;
}

}  // namespace abstand::verify
