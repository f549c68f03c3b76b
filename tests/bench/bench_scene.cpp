#include "tests/bench/bench_scene.hpp"

#include <cmath>

#include "app/session/session.hpp"
#include "core/base/data_folder.hpp"
#include "core/verify/meshes.hpp"
#include "tests/support/bumpy_meshes.hpp"

namespace abstand::bench {
namespace {

constexpr double kRate = 1000.0;          // Hz
constexpr double kBallSagitta = 0.0002;   // m, of balls that become meshes
constexpr double kPersonSagitta = 0.001;  // m, of a person's parts
constexpr double kCoarse = 0.05;          // m, for structures of which only the surfaces are needed
constexpr std::size_t kSamples = 16;      // of a scene, for engines that need milliseconds a frame
constexpr std::size_t kFewSamples = 50;

structure::HapticOptions options(double voxel, double point) {
  return {.voxel_size = voxel, .point_spacing = point, .outer_layers = 20};
}

/// Every triangle cut into four.
geometry::TriangleMesh quartered(const geometry::TriangleMesh& mesh) {
  geometry::TriangleMesh fine;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    const Vector3d ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    for (const auto& corners : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      const auto first = static_cast<std::uint32_t>(fine.vertices.size());
      fine.vertices.insert(fine.vertices.end(), corners.begin(), corners.end());
      fine.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return geometry::weld(fine, 0.0);
}

std::vector<double> times(double start, double end) {
  std::vector<double> t;
  const auto count = static_cast<std::size_t>(std::lround((end - start) * kRate));
  for (std::size_t i = 0; i < count; ++i) t.push_back(start + static_cast<double>(i) / kRate);
  return t;
}

scene_file::SceneDescription shipped(const char* file) {
  return scene_file::loadScene(dataFolder() / "scenes" / file);
}

/// Bodies, pairs and poses as a session has them; at the frames of its recording where `t` is empty.
BenchScene fromSession(scene_file::SceneDescription description, std::vector<double> t, double sagitta) {
  description.defaults.haptic = options(kCoarse, kCoarse);
  for (auto& object : description.objects) object.settings.voxel = object.settings.point = kCoarse;
  session::SessionOptions session_options;
  session_options.threads = 1;
  session_options.cache = false;
  session::Session session(std::move(description), session_options);
  BenchScene scene;
  for (const scene::Object& o : session.scene().objects())
    scene.bodies.push_back({o.spec.name, o.spec.structure->surface->mesh(sagitta)});
  for (const scene::Pair& p : session.scene().pairs()) scene.pairs.emplace_back(p.a.index(), p.b.index());
  if (t.empty()) t = session.frameTimes();
  for (const double time : t) {
    session.applyMotion(time);
    for (const scene::Object& o : session.scene().objects()) scene.X_WB.push_back(o.X_WB);
  }
  return scene;
}

}  // namespace

std::size_t BenchScene::triangles() const {
  std::size_t sum = 0;
  for (const Body& b : bodies) sum += b.mesh.triangles.size();
  return sum;
}

const BenchScene& threeSpheres() {
  static const BenchScene scene = [] {
    BenchScene s = fromSession(shipped("spheres.yaml"), times(0.0, 2.0), kBallSagitta);
    s.name = "spheres";
    s.what = "three spheres of 50 mm";
    s.options = options(0.004, 0.004);
    s.sparse = s.frames() / kFewSamples;
    return s;
  }();
  return scene;
}

const BenchScene& rods() {
  static const BenchScene scene = [] {
    BenchScene s = fromSession(shipped("rods.yaml"), times(0.5, 2.5), kBallSagitta);
    s.name = "rods";
    s.what = "two rods of 40 x 40 x 400 mm";
    s.options = options(0.002, 0.003);
    s.sparse = s.frames() / kFewSamples;
    for (auto& body : s.bodies)
      for (int i = 0; i < 4; ++i) body.mesh = quartered(body.mesh);
    return s;
  }();
  return scene;
}

const BenchScene& armsPersonTable() {
  static const BenchScene scene = [] {
    scene_file::SceneDescription description = shipped("hug_boxing.yaml");
    scene_file::ObjectDescription table;
    table.name = "table";
    table.mesh = dataFolder() / "robots" / "hug" / "table.stl";
    table.X_WB.translation() = Vector3d(0.2, 0.0, 0.0);
    description.objects.push_back(table);
    description.humans.at(0).recording.place_xyz.x() -= 0.05;
    BenchScene s = fromSession(std::move(description), {}, kPersonSagitta);
    s.name = "arms_person_table";
    s.what = "two arms, a boxer, column, table";
    s.options = options(0.004, 0.004);
    s.sparse = s.frames() / kSamples;
    return s;
  }();
  return scene;
}

const BenchScene& bunnyOnBunny() {
  static const BenchScene scene = [] {
    BenchScene s;
    s.name = "bunnies";
    s.what = "two bumpy balls of about 200 mm";
    s.options = options(0.002, 0.002);
    const geometry::TriangleMesh mesh = testing::bumpyBall(0.1, 8.5e-6);
    s.bodies = {{"fixed", mesh}, {"turning", mesh}};
    s.pairs = {{0, 1}};
    for (const double t : times(0.0, 2.0)) {
      Transform X = Transform::Identity();
      X.linear() = (Eigen::AngleAxisd(kPi * t, Vector3d::UnitY()) *
                    Eigen::AngleAxisd(0.3 * std::sin(2.0 * t), Vector3d::UnitX()))
                       .toRotationMatrix();
      X.translation() = Vector3d(0.232 + 0.014 * std::sin(3.0 * kPi * t), 0.01 * std::sin(3.0 * t), 0.0);
      s.X_WB.push_back(Transform::Identity());
      s.X_WB.push_back(X);
    }
    s.sparse = s.frames() / kFewSamples;
    return s;
  }();
  return scene;
}

const BenchScene& pegInHole() {
  static const BenchScene scene = [] {
    constexpr double kHole = 0.025, kPeg = 0.0249, kBlock = 0.05, kHeight = 0.1, kPegLength = 0.12;
    constexpr int kSides = 128;
    BenchScene s;
    s.name = "peg";
    s.what = "peg in hole, 0.1 mm to spare";
    s.options = options(0.001, 0.0015);
    // Rows of corners along the walls, so that no triangle is as long as the hole is deep. The hole's flats
    // are kHole from its axis.
    constexpr int kRows = 24;
    const double inner = kHole / std::cos(kPi / kSides);
    std::vector<std::pair<double, double>> block, peg;
    for (int i = 0; i <= kRows; ++i)
      block.emplace_back(inner, kHeight * (0.5 - static_cast<double>(i) / kRows));
    for (int i = 0; i <= kRows; ++i)
      block.emplace_back(kBlock, kHeight * (static_cast<double>(i) / kRows - 0.5));
    s.bodies.push_back({"block", verify::latheMesh(block, kSides)});
    s.bodies.push_back(
        {"peg", geometry::makeSurface(geometry::Shape{geometry::Cylinder{kPeg, kPegLength}})->mesh(1e-5)});
    s.pairs = {{0, 1}};
    for (const double t : times(0.0, 2.0)) {
      const double aside = 0.00006 + 0.00008 * std::sin(2.6 * kPi * t);  // m
      Transform X = Transform::Identity();
      X.linear() = (Eigen::AngleAxisd(0.0005 * std::sin(5.0 * t), Vector3d::UnitX()) *
                    Eigen::AngleAxisd(0.5 * t, Vector3d::UnitZ()))
                       .toRotationMatrix();
      X.translation() =
          Vector3d(aside * std::cos(4.0 * t), aside * std::sin(4.0 * t), 0.06 + 0.055 * std::cos(kPi * t));
      s.X_WB.push_back(Transform::Identity());
      s.X_WB.push_back(X);
    }
    s.sparse = s.frames() / kFewSamples;
    return s;
  }();
  return scene;
}

}  // namespace abstand::bench
