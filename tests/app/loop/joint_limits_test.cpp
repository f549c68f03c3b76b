// Whatever a law asks for, the joints of a robot in the closed loop stay within its file.
#include <gtest/gtest.h>

#include <cmath>

#include "app/loop/closed_loop.hpp"
#include "core/base/number.hpp"
#include "core/math/random.hpp"
#include "tests/support/paths.hpp"

namespace abstand::loop {
namespace joint_limits_test {

// Relative, and absolute in rad, rad/s, N m: what may be beyond a limit by rounding.
constexpr double kShare = 1e-6, kRounding = 1e-9;
constexpr int kCycles = 3000;

struct Case {
  const char* name;
  const char* reaction;
  double plan_speed;  // of the plan, over that of a plan that an LWR can do
};

/// The thing flies about the arm beyond its reach, so nothing ever touches it: all pushes are the laws'.
std::string flight(std::uint64_t seed) {
  Random random(seed, 0);
  std::string csv =
      "t,thing.r00,thing.r01,thing.r02,thing.tx,thing.r10,thing.r11,thing.r12,thing.ty,thing.r20,thing.r21,"
      "thing.r22,thing.tz\n";
  double turn = 0.0, height = 0.3, speed = 3.0;
  for (int i = 0; i <= kCycles; ++i) {
    if (i % 200 == 0) speed = random.between(-8.0, 8.0);
    turn += 1e-3 * speed;
    height = 0.6 + 0.5 * std::sin(0.004 * i);
    csv += formatDouble(1e-3 * i) + ",1,0,0," + formatDouble(1.6 * std::cos(turn)) + ",0,1,0," +
           formatDouble(1.6 * std::sin(turn)) + ",0,0,1," + formatDouble(height) + "\n";
  }
  return csv;
}

std::string plan(std::uint64_t seed, double speed) {
  Random random(seed, 0);
  std::string csv = "t,q0,q1,q2,q3,q4,q5,q6\n";
  for (int row = 0; row <= 12; ++row) {
    csv += formatDouble(0.25 * row);
    for (int k = 0; k < 7; ++k) csv += "," + formatDouble(0.15 * speed * random.between(-1.0, 1.0));
    csv += "\n";
  }
  return csv;
}

class ClosedLoopLimits : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    All, ClosedLoopLimits,
    ::testing::Values(
        Case{"Hold", "{hold: {frequency: 60, damping: 0}}", 1.0},
        Case{"HoldOfAPlanThatIsTooFast", "{}", 12.0}, Case{"Torque", "{torque: {gain: 1}}", 1.0},
        Case{"TorqueLimit", "{torque: {gain: 1, limit: 1000, cut: each}}", 1.0},
        Case{"Repulsion", "{repulsion: {range: 2, force: 2000, damping: 0.05}, stop: {on: {energy: none}}}",
             1.0},
        Case{"RepulsionAndBrakes", "{repulsion: {range: 2, force: 2000, damping: 0.05}}", 1.0},
        Case{"Admittance",
             "{repulsion: {range: 2, force: 2000, damping: 0}, admittance: {inertia: 0.1, damping: 0.1, "
             "stiffness: 0, velocity: 50, offset: 10}, stop: {on: {energy: none}}}",
             1.0},
        Case{"AdmittanceOfAPlanThatIsTooFast", "{admittance: {}}", 12.0},
        Case{"Proxy", "{proxy: {stiffness: 100000, force: 5000, torque: 500}}", 4.0},
        Case{"Speed",
             "{speed: {}, repulsion: {range: 2, force: 500, damping: 0}, stop: {on: {energy: none}}}", 6.0},
        Case{"Braking", "{braking: {deceleration: 50}, torque: {gain: 1}, stop: {resume_after: 0.1}}", 6.0}),
    [](const auto& law) { return std::string(law.param.name); });

TEST_P(ClosedLoopLimits, EveryLawKeepsPositionVelocityAndEffort) {
  testing::ScratchFolder folder;
  folder.write("poses.csv", flight(1));
  folder.write("plan.csv", plan(2, GetParam().plan_speed));
  const std::string held = std::string(GetParam().name) == "Proxy" ? ", held: true" : "";
  scene_file::SceneDescription description = scene_file::parseScene(
      "abstand: 1\n"
      "defaults: {voxel: 0.03, point: 0.03, stiffness: 1.0e6}\n"
      "mechanisms:\n"
      "  - name: arm\n"
      "    file: " +
          testing::projectFile("data/robots/lwr/lwr4.mech").string() +
          "\n"
          "    motion: plan.csv\n"
          "    reaction: " +
          GetParam().reaction +
          "\n"
          "    links:\n"
          "      - {name: elbow, frame: 4, shape: {sphere: {radius: 0.08}}}\n"
          "      - {name: hand, frame: 7, shape: {sphere: {radius: 0.06}}" +
          held +
          "}\n"
          "objects:\n"
          "  - {name: thing, shape: {sphere: {radius: 0.1}}, margin: 0.9}\n"
          "pairs: {default: between_groups}\n",
      folder.path() / "scene.yaml");
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  options.poses = folder.path() / "poses.csv";
  session::Session session(std::move(description), options);
  ClosedLoop loop(session, 0.0);
  const ReactingRobot& robot = *loop.robots()[0];
  const auto& frames = robot.driver().mechanism().frames;
  double max_share = 0.0, travel = 0.0;
  for (int i = 0; i < kCycles; ++i) {
    loop.step();
    for (std::size_t k = 0; k < 7; ++k) {
      const mechanism::JointLimits& l = frames[k].limits;
      const auto within = [&](double x, double lower, double upper) {
        const double slack = kRounding + kShare * std::max(std::abs(lower), std::abs(upper));
        return x >= lower - slack && x <= upper + slack;
      };
      ASSERT_TRUE(within(robot.q()[k], l.lower, l.upper)) << "q" << k << " " << robot.q()[k] << " at " << i;
      ASSERT_TRUE(within(robot.qd()[k], -l.velocity, l.velocity))
          << "qd" << k << " " << robot.qd()[k] << " limit " << l.velocity << " at " << i;
      ASSERT_TRUE(within(robot.applied()[k], -l.effort, l.effort))
          << "effort" << k << " " << robot.applied()[k] << " limit " << l.effort << " at " << i;
      max_share = std::max(max_share, std::abs(robot.qd()[k]) / l.velocity);
      travel += 1e-3 * std::abs(robot.qd()[k]);
    }
  }
  EXPECT_TRUE(robot.limits().kept());
  EXPECT_LE(max_share, 1.0 + kShare);
  EXPECT_GT(travel, 0.5) << "it did move";
}

}  // namespace joint_limits_test
}  // namespace abstand::loop
