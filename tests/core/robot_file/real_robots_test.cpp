// Robots of others load and move; the two descriptions of one arm agree. Skipped where the files are absent.
#include <gtest/gtest.h>

#include "core/mechanism/joint_range.hpp"
#include "core/robot_file/dh_mechanism.hpp"
#include "core/robot_file/mech_file.hpp"
#include "core/robot_file/mesh_reference.hpp"
#include "core/robot_file/robot_writer.hpp"
#include "tests/support/paths.hpp"

namespace abstand::robot_file {
namespace real_robots_test {

struct RealRobot {
  const char* file;
  int dof, frames;
  std::size_t collisions;
};
void PrintTo(const RealRobot& r, std::ostream* out) { *out << r.file; }
class RealRobots : public ::testing::TestWithParam<RealRobot> {};

TEST_P(RealRobots, LoadMoveAndConvert) {
  const auto file = testing::sharedData(std::string("robots/") + GetParam().file);
  if (!exists(file)) GTEST_SKIP() << file;
  const Robot robot = loadRobot(file);
  EXPECT_EQ(robot.mechanism.dof, GetParam().dof);
  EXPECT_EQ(robot.mechanism.frames.size(), static_cast<std::size_t>(GetParam().frames));

  // Every collision mesh is found, by walking up.
  MeshFinder finder(file, {{}, false});
  std::size_t collisions = 0;
  for (const auto& g : robot.geometry) {
    if (g.use != GeometryUse::kCollision) continue;
    ++collisions;
    EXPECT_TRUE(g.shape || finder.find(g.mesh)) << g.mesh;
  }
  EXPECT_EQ(collisions, GetParam().collisions);

  // It moves: every dof moves some frame, and everything stays within reach.
  const auto ranges = mechanism::jointRanges(robot.mechanism);
  std::vector<double> q(ranges.size());
  mechanism::MechanismState home, moved;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = 0.5 * (ranges[i].lower + ranges[i].upper);
  mechanism::forward(robot.mechanism, q, home);
  for (std::size_t i = 0; i < q.size(); ++i) {
    auto p = q;
    // Not to the end of the range: two turns of a joint end where they began.
    p[i] += 0.1 * (ranges[i].upper - ranges[i].lower);
    mechanism::forward(robot.mechanism, p, moved);
    bool any = false;
    for (std::size_t f = 0; f < moved.X_BF.size(); ++f) {
      any = any || !moved.X_BF[f].isApprox(home.X_BF[f], 1e-6);
      EXPECT_LT(moved.X_BF[f].translation().norm(), 3.0);
    }
    EXPECT_TRUE(any) << "dof " << i;
  }

  // As a table and as a URDF it is the same robot.
  const auto table =
      postureResidual(robot.mechanism, parseMech(mechText(toDh(robot)), "r.mech").mechanism, 200);
  EXPECT_LT(table.position, 1e-9);
  EXPECT_LT(table.angle, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, RealRobots,
                         ::testing::Values(RealRobot{"kuka_lwr4plus/kuka.urdf", 7, 8, 8},
                                           RealRobot{"kuka_lwr4plus_dh_xacro/kuka_lwr_dh_flattened.urdf", 7,
                                                     10, 7},
                                           RealRobot{"kuka_iiwa14/model.urdf", 7, 8, 8},
                                           RealRobot{"franka_panda/panda.urdf", 8, 13, 11},
                                           RealRobot{"ur5/urdf/ur5_robot.urdf", 6, 11, 8},
                                           RealRobot{"nao_humanoid/nao.urdf", 25, 79, 47}));

/// The largest distance of the flange over 1,000 random postures of the shipped arm. `signs`: of the other
/// model's joints; `X`: its flange in the shipped one's.
double flangeDifference(const std::string& file, const std::string& flange,
                        const std::vector<double>& signs) {
  const mechanism::Mechanism lwr = loadMechanism(testing::projectFile("data/robots/lwr/lwr4.mech"));
  const Robot other = loadRobot(testing::sharedData("robots/" + file));
  const int at = other.mechanism.indexOf(flange);
  if (at < 0) return kInfinity;
  mechanism::MechanismState a, b;
  double most = 0.0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    Random random(11, k);
    std::vector<double> q(7), p(7);
    for (std::size_t i = 0; i < 7; ++i) {
      q[i] = random.between(-2.9, 2.9);
      p[i] = signs[i] * q[i];
    }
    mechanism::forward(lwr, q, a);
    mechanism::forward(other.mechanism, p, b);
    const Vector3d difference = b.X_BF[static_cast<std::size_t>(at)].translation() - a.X_BF[6].translation();
    most = std::max(most, difference.norm());
  }
  return most;
}

TEST(ShippedLwr, MatchesUrdfsOfArm) {
  if (!exists(testing::sharedData("robots/kuka_lwr4plus/kuka.urdf"))) GTEST_SKIP();
  // kuka.urdf has d1 = 0.11 + 0.20 = 0.310 m, lwr4.mech 0.3105 m, as the DH table and the other URDF: half a
  // millimetre along the first axis, in every posture the same.
  const std::vector<double> plus(7, 1.0);
  EXPECT_NEAR(flangeDifference("kuka_lwr4plus/kuka.urdf", "kuka_arm_7_link", plus), 0.5e-3, 1e-9);
  // The other one turns joints 2, 4 and 6 the other way round.
  const std::vector<double> turned{1, -1, 1, -1, 1, -1, 1};
  EXPECT_LT(flangeDifference("kuka_lwr4plus_dh_xacro/kuka_lwr_dh_flattened.urdf", "lwr_arm_ee_link", turned),
            1e-9);
}

}  // namespace real_robots_test
}  // namespace abstand::robot_file
