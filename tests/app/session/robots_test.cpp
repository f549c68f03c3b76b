// Whole scenes of robots: the shipped ones, and those of others where they are there.
#include <gtest/gtest.h>

#include <set>

#include "app/run/collision_pairs.hpp"
#include "app/session/session.hpp"
#include "core/mechanism/joint_range.hpp"
#include "tests/support/paths.hpp"

namespace abstand::session {
namespace robots_test {

std::unique_ptr<Session> sessionOf(scene_file::SceneDescription scene) {
  scene.defaults.haptic.voxel_size = scene.defaults.haptic.point_spacing = 0.02;
  SessionOptions options;
  options.threads = 1;
  options.cache = false;
  return std::make_unique<Session>(std::move(scene), options);
}

struct Shipped {
  const char* scene;
  int dof;
  std::size_t links;
};
void PrintTo(const Shipped& s, std::ostream* out) { *out << s.scene; }
class ShippedRobots : public ::testing::TestWithParam<Shipped> {};

TEST_P(ShippedRobots, LoadAndRun) {
  const auto session =
      sessionOf(scene_file::loadScene(testing::projectFile(std::string("data/scenes/") + GetParam().scene)));
  ASSERT_EQ(session->mechanisms().size(), 1u);
  const MechanismDriver& robot = *session->mechanisms()[0];
  EXPECT_EQ(robot.dof(), GetParam().dof);
  EXPECT_EQ(robot.links().size(), GetParam().links);
  EXPECT_GT(session->scene().pairs().size(), 0u);
  const double end = robot.motion()->end();
  for (const double t : {0.0, 0.3 * end, 0.7 * end}) session->step(t);
  for (const scene::Pair& pair : session->scene().pairs()) EXPECT_TRUE(std::isfinite(pair.result.distance));

  // The motion keeps to the limits, and every link has a mass.
  const auto ranges = mechanism::jointRanges(robot.mechanism());
  std::vector<double> q(ranges.size());
  for (int k = 0; k <= 200; ++k) {
    robot.motion()->at(end * k / 200.0, q);
    for (std::size_t i = 0; i < q.size(); ++i) {
      EXPECT_GE(q[i], ranges[i].lower - 1e-9) << "dof " << i << " at " << end * k / 200.0;
      EXPECT_LE(q[i], ranges[i].upper + 1e-9) << "dof " << i << " at " << end * k / 200.0;
    }
  }
  for (const auto& link : robot.links())
    EXPECT_GT(robot.mechanism().frames[static_cast<std::size_t>(link.frame)].inertia.mass, 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedRobots,
                         ::testing::Values(Shipped{"arm6.yaml", 6, 7}, Shipped{"rail7.yaml", 8, 12},
                                           Shipped{"humanoid.yaml", 47, 70}));

class RealRobotScenes : public ::testing::TestWithParam<const char*> {};

/// A ball in the place of the robot's last body touches it, and its joints feel it.
TEST_P(RealRobotScenes, Collide) {
  const auto file = testing::sharedData(std::string("robots/") + GetParam());
  if (!exists(file)) GTEST_SKIP() << file;
  const auto scene = [&](const Vector3d& p) {
    return scene_file::parseScene("abstand: 1\nmechanisms: [{name: robot, file: " + file.string() +
                                      "}]\nobjects:\n  - {name: ball, shape: {sphere: "
                                      "{radius: 0.05}}, pose: {xyz: [" +
                                      std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " +
                                      std::to_string(p.z()) + "]}}\npairs: {default: between_groups}\n",
                                  "scene.yaml", {{}, false});
  };
  const auto far = sessionOf(scene({50, 0, 0}));
  far->step(0.0);
  Vector3d p_WC = Vector3d::Zero();
  double farthest = -1.0;
  for (const scene::Object& o : far->scene().objects()) {
    if (o.spec.group != "robot" || o.X_WB.translation().norm() < farthest) continue;
    farthest = o.X_WB.translation().norm();
    p_WC = o.p_WCom();
  }
  for (const scene::Pair& pair : far->scene().pairs()) EXPECT_GT(pair.result.distance, 40.0);
  // Off centre, so that the force has an arm about the last joints.
  const auto near = sessionOf(scene(p_WC + Vector3d(0.02, 0.03, 0.01)));
  near->step(0.0);
  double effort = 0.0;
  for (const double e : near->jointEfforts()) effort += std::abs(e);
  EXPECT_TRUE(near->scene().find("ball")->colliding);
  EXPECT_GT(effort, 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, RealRobotScenes,
                         ::testing::Values("kuka_lwr4plus/kuka.urdf",
                                           "kuka_lwr4plus_dh_xacro/kuka_lwr_dh_flattened.urdf",
                                           "kuka_iiwa14/model.urdf", "franka_panda/panda.urdf",
                                           "ur5/urdf/ur5_robot.urdf", "nao_humanoid/nao.urdf"));

TEST(CollisionPairs, MatchPairsFileOfShippedRobot) {
  auto scene = scene_file::loadScene(testing::projectFile("data/scenes/arm6.yaml"));
  scene.objects.clear();
  scene.pairs.exclude = {{"arm6/base", "arm6/flange"}};
  const auto session = sessionOf(scene);
  study::StudyOptions options;
  options.samples = 300;
  options.threads = 1;
  const auto pairs = run::collisionPairs(*session, options);
  ASSERT_EQ(pairs.size(), 21u);
  const auto rows = study::parsePairs(run::pairsText(*session, pairs, options), "t.pairs");
  ASSERT_EQ(rows.size(), 21u);
  std::set<std::string> adjacent;
  for (const auto& row : rows)
    if (row.verdict == study::PairVerdict::kAdjacent) adjacent.insert(row.a + " " + row.b);
  EXPECT_EQ(adjacent, (std::set<std::string>{"arm6/base arm6/shoulder", "arm6/shoulder arm6/upper_arm",
                                             "arm6/upper_arm arm6/elbow", "arm6/elbow arm6/forearm",
                                             "arm6/forearm arm6/wrist", "arm6/wrist arm6/flange"}));
  EXPECT_EQ(rows[5].verdict, study::PairVerdict::kUser);
  // Whatever the samples say, the elbow cannot reach the base: 0.17 m remain.
  EXPECT_EQ(rows[2].b, "arm6/elbow");
  EXPECT_EQ(rows[2].verdict, study::PairVerdict::kNever);
  EXPECT_NEAR(pairs[2].study.distance, 0.169, 0.005);
  const robot_file::Srdf srdf = run::srdfOf(*session, pairs);
  EXPECT_EQ(srdf.robot, "arm6");
  for (const auto& p : srdf.disabled) EXPECT_NE(p.reason, "Sometimes");
  EXPECT_EQ(srdf.disabled.size(),
            static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const study::PairRow& r) {
              return r.verdict != study::PairVerdict::kSometimes;
            })));
}

}  // namespace robots_test
}  // namespace abstand::session
