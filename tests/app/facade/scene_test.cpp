// Scenes as programs of others make them: the same numbers as a session, from files, from parts, and live.
#include "abstand/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "abstand/human.hpp"
#include "abstand/mechanism.hpp"
#include "abstand/recording.hpp"
#include "app/session/session.hpp"
#include "tests/support/paths.hpp"

namespace abstand {
namespace scene_test {

using testing::projectFile;
using testing::ScratchFolder;

constexpr StructureOptions kCoarse{.voxel_size = 0.02, .point_spacing = 0.02};

Pose at(double x, double y, double z) {
  Pose X = Pose::Identity();
  X.translation() << x, y, z;
  return X;
}

const char* const kPeopleAndArm = R"(abstand: 1
defaults: {voxel: 0.02, point: 0.02}
mechanisms:
  - {name: arm, file: ARM, q: [0.1, 0.6, 0.9, 0.0, 0.4, 0.0]}
humans:
  - {name: visitor, height: 1.8, recording: {file: BVH, place: {xyz: [0.9, 0, 0], yaw: 3.0}}}
pairs: {default: between_groups}
)";

std::string withFiles(std::string text) {
  text.replace(text.find("ARM"), 3, projectFile("data/robots/arm6/arm6.urdf").string());
  return text.replace(text.find("BVH"), 3, projectFile("data/scenes/hug_reach.bvh").string());
}

TEST(LibraryScene, FileAndBuilderGiveSameScene) {
  const ScratchFolder folder;
  const SceneOptions options{.threads = 2, .cache = false};
  Scene file = Scene::load(folder.write("scene.yaml", withFiles(kPeopleAndArm)), options);
  RobotOptions robot;
  robot.q = {0.1, 0.6, 0.9, 0.0, 0.4, 0.0};
  PersonOptions person;
  person.height = 1.8;
  person.recording = projectFile("data/scenes/hug_reach.bvh");
  person.place << 0.9, 0.0, 0.0;
  person.yaw = 3.0;
  SceneBuilder builder;
  builder.addRobot("arm", projectFile("data/robots/arm6/arm6.urdf"), robot)
      .addPerson("visitor", person)
      .setResolution(0.02, 0.02);
  Scene parts(builder, options);
  ASSERT_EQ(parts.objects(), file.objects());
  ASSERT_EQ(parts.pairs(), file.pairs());
  ASSERT_GT(parts.pairs(), 50u);
  EXPECT_EQ(parts.frameTimes(), file.frameTimes());
  EXPECT_EQ(parts.people(), 1u);
  EXPECT_EQ(parts.dof(0), 6);
  for (const double t : {0.0, 1.0, 2.0}) {
    file.step(t);
    parts.step(t);
    EXPECT_EQ(parts.nearest(), file.nearest());
    for (std::size_t i = 0; i < parts.pairs(); ++i) {
      EXPECT_EQ(parts.result(i).distance, file.result(i).distance);
      EXPECT_EQ(parts.result(i).bound, file.result(i).bound);
    }
  }
  EXPECT_EQ(parts.jointValues(0), robot.q);
  // From nothing but the poses, whatever was asked before.
  Scene warm(builder, options), cold(builder, options);
  for (const double t : {0.0, 1.0, 2.0}) {
    cold.startCold();
    cold.step(t);
    if (t == 2.0) warm.startCold();
    warm.step(t);
  }
  for (std::size_t i = 0; i < cold.pairs(); ++i) EXPECT_EQ(cold.result(i).distance, warm.result(i).distance);
}

TEST(LibraryScene, LiveMatchesRecorded) {
  const SceneOptions options{.threads = 1, .cache = false};
  PersonOptions person;
  person.recording = projectFile("data/scenes/hug_reach.bvh");
  SceneBuilder builder;
  builder.addRobot("arm", projectFile("data/robots/arm6/arm6.urdf")).setResolution(0.02, 0.02);
  builder.addPerson("visitor", person);
  Scene recorded(builder, options), live(builder, options);
  const Recording recording = Recording::open(person.recording);
  EXPECT_GT(recording.stature(), 1.5);
  for (std::size_t i = 0; i < 5; ++i) {
    const Skeleton& skeleton = recording.frames()[i];
    recorded.step(skeleton.t);
    live.moveRobot(0, std::vector<double>(6, 0.0), skeleton.t);
    live.movePerson(0, skeleton);
    live.query(skeleton.t);
    for (std::size_t k = 0; k < live.pairs(); ++k)
      EXPECT_EQ(live.result(k).distance, recorded.result(k).distance) << i << " " << k;
  }
  EXPECT_LT(live.uncertainty(0), 1e-3);
  const double t = recording.frames()[4].t;
  live.query(t + 0.5);  // half a second without the person
  EXPECT_GT(live.uncertainty(0), 0.1);
  EXPECT_THROW(live.moveRobot(0, std::vector<double>(5, 0.0), t), std::runtime_error);
  EXPECT_THROW(live.moveRobot(0, std::vector<double>(6, NAN), t), std::runtime_error);
  EXPECT_THROW(live.moveRobot(1, {}, t), std::out_of_range);
  EXPECT_THROW(live.result(live.pairs()), std::out_of_range);
}

TEST(LibraryScene, ObjectsCollideAndExertForces) {
  const Structure box = Structure::build(Shape::cuboid({0.2, 0.2, 0.2}), kCoarse);
  const Structure small = Structure::build(Shape::cuboid({0.1, 0.1, 0.1}), {.point_spacing = 0.01});
  SceneBuilder builder;
  builder.addObject("a", box).addObject("b", small, at(0.45, 0, 0)).setStiffness(1e5);
  EXPECT_THROW(builder.addObject("a", box), std::runtime_error);
  EXPECT_THROW(builder.addObject("c", box, at(0, 0, 0), -1.0), std::runtime_error);
  Scene scene(builder, {.threads = 1, .cache = false});
  ASSERT_EQ(scene.pairs(), 1u);
  scene.step(0.0);
  EXPECT_NEAR(scene.result(0).distance, 0.3, 1e-5);
  EXPECT_TRUE(scene.touching().empty());
  EXPECT_TRUE(scene.moveObject(*scene.findObject("b"), at(0.12, 0, 0), 0.1));
  Pose bad = at(0, 0, 0);
  bad.linear() *= 3.0;
  EXPECT_FALSE(scene.moveObject(0, bad, 0.1));
  EXPECT_EQ(scene.poseState(0), PoseState::kRejected);
  EXPECT_TRUE(scene.moveObject(0, at(0, 0, 0), 0.1));
  scene.query(0.1);
  // k times the overlapping volume.
  const double force = 1e5 * 0.1 * 0.1 * 0.03;
  EXPECT_EQ(scene.touching(), std::vector<std::size_t>{0});
  EXPECT_NEAR(scene.force(0).x(), -force, 0.1 * force);
  EXPECT_NEAR((scene.force(0) + scene.force(1)).norm(), 0.0, 1e-9);
}

TEST(LibraryScene, HumanPoseMatchesScene) {
  PersonOptions person;
  person.recording = projectFile("data/scenes/hug_reach.bvh");
  SceneBuilder builder;
  builder.addPerson("visitor", person).setResolution(0.03, 0.03);
  Scene scene(builder, {.threads = 1, .cache = false});
  scene.step(scene.frameTimes()[0]);
  const Human human;
  HumanPoser poser(human);
  const Recording recording = Recording::open(person.recording);
  poser.calibrate(recording.frames());
  const HumanPose pose = poser.pose(recording.at(0.0));
  ASSERT_EQ(pose.X_WP.size(), human.parts().size());
  for (std::size_t i = 0; i < human.parts().size(); ++i) {
    EXPECT_EQ(scene.objectName(i), "visitor/" + human.parts()[i].name);
    EXPECT_NEAR((scene.pose(i).matrix() - pose.X_WP[i].matrix()).cwiseAbs().maxCoeff(), 0.0, 1e-12);
  }
  EXPECT_EQ(findJoint(jointName(Joint::kWristLeft)), Joint::kWristLeft);
}

TEST(LibraryScene, LoadsBodyFromStructureFile) {
  const ScratchFolder folder;
  const Structure box = Structure::build(Shape::cuboid({0.2, 0.1, 0.2}), kCoarse, "crate");
  box.save(folder.path() / "crate.structure");
  const auto file = folder.write("scene.yaml", R"(abstand: 1
objects:
  - {name: crate, structure: crate.structure, margin: 0.01}
  - {name: ball, shape: {sphere: {radius: 0.1}}, voxel: 0.02, point: 0.02, pose: {xyz: [0.5, 0, 0]}}
)");
  Scene scene = Scene::load(file, {.threads = 1, .cache = false});
  scene.step(0.0);
  const PairResult alone = queryPair(box, at(0, 0, 0), Structure::build(Shape::sphere(0.1), kCoarse),
                                     at(0.5, 0, 0), {.margin = 0.01});
  EXPECT_NEAR(scene.result(0).distance, alone.distance, 1e-5);
  EXPECT_NEAR(alone.distance, 0.3, 1e-5);
  // Written and read again, it is the same.
  const scene_file::SceneDescription read = scene_file::loadScene(file);
  const std::string text = scene_file::describeScene(read);
  EXPECT_NE(text.find("structure: "), std::string::npos);
  EXPECT_EQ(scene_file::describeScene(scene_file::parseScene(text, file)), text);
  // A damaged one is named.
  std::ofstream(folder.path() / "crate.structure", std::ios::binary | std::ios::app) << "x";
  try {
    Scene::load(file);
    ADD_FAILURE() << "read a damaged file";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("crate.structure: error: is damaged"), std::string::npos)
        << e.what();
  }
}

}  // namespace scene_test
}  // namespace abstand
