// Things in the closed loop that the physics moves, and what a robot holds: both in closed form.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/loop/closed_loop.hpp"
#include "core/base/error.hpp"
#include "tests/app/loop/slide_scene.hpp"
#include "tests/support/no_alloc.hpp"

namespace abstand::loop {
namespace things_test {

std::unique_ptr<session::Session> sessionOf(const std::string& text, const testing::ScratchFolder& folder,
                                            const std::filesystem::path& poses = {}) {
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  options.poses = poses;
  return std::make_unique<session::Session>(scene_file::parseScene(text, folder.path() / "scene.yaml"),
                                            options);
}

void steps(ClosedLoop& loop, int count) {
  for (int i = 0; i < count; ++i) loop.step();
}

// m/s^2: the norm of mechanism::kGravity, which may not be initialized yet when this file is.
constexpr double kG = 9.80665;

class FallingObjects : public ::testing::Test {
 protected:
  /// A ball of 5 cm and half a kilogram with its lowest point `height` over a table whose top is z = 0.
  void scene(double height, const std::string& mass = "mass: 0.5") {
    session_ = sessionOf(
        "abstand: 1\ndefaults: {voxel: 0.005, point: 0.005, stiffness: 1.0e7}\nobjects:\n"
        "  - {name: table, shape: {cuboid: {size: [0.5, 0.5, 0.1]}}, pose: {xyz: [0, 0, -0.05]}}\n"
        "  - {name: ball, shape: {sphere: {radius: 0.05}}, pose: {xyz: [0, 0, " +
            std::to_string(height + 0.05) + "]}, " + mass + "}\n",
        folder_);
  }
  const scene::Object& ball() const { return *session_->scene().find("ball"); }

  testing::ScratchFolder folder_;
  std::unique_ptr<session::Session> session_;
};

TEST_F(FallingObjects, FallFreelyUntilContact) {
  scene(0.3);
  ASSERT_TRUE(session_->reacts());
  ClosedLoop loop(*session_, 0.0);
  EXPECT_EQ(loop.freeThings(), 1u);
  steps(loop, 201);  // shows 0.2 s
  // Semi-implicit Euler at a millisecond is g t dt / 2 ahead of the parabola.
  EXPECT_NEAR(ball().X_WB.translation().z(), 0.35 - 0.5 * kG * 0.2 * 0.201, 1e-6);
}

TEST_F(FallingObjects, RestWhereOverlapForceCarriesWeight) {
  scene(0.02);
  ClosedLoop loop(*session_, 0.0);
  steps(loop, 3000);
  // m g = k V with the cap V = pi h^2 (3 r - h) / 3.
  double low = 0.0, high = 0.01;
  for (int i = 0; i < 60; ++i) {
    const double h = 0.5 * (low + high);
    (1e7 * kPi * h * h * (0.15 - h) / 3.0 < 0.5 * kG ? low : high) = h;
  }
  EXPECT_NEAR(ball().contact.force.z(), 0.5 * kG, 1e-3 * kG);
  // Depths of less than a point's spacing are those of few points.
  EXPECT_NEAR(0.05 - ball().X_WB.translation().z(), low, 0.5e-3);
  EXPECT_LT(std::abs(ball().velocity.linear.z()), 1e-4);
  // Nothing keeps a ball from rolling, and its points are not quite round.
  EXPECT_LT(ball().X_WB.translation().head<2>().norm(), 5e-3);
}

TEST_F(FallingObjects, StayPutWithoutMassOrWithGivenPoses) {
  scene(0.3, "margin: 0");
  EXPECT_FALSE(session_->reacts());
  EXPECT_EQ(session_->frameTimes().size(), 1u);
  scene(0.3);
  EXPECT_EQ(session_->frameTimes().size(), 5001u) << "5 s";

  folder_.write("poses.csv",
                "t,ball.r00,ball.r01,ball.r02,ball.tx,ball.r10,ball.r11,ball.r12,ball.ty,ball.r20,"
                "ball.r21,ball.r22,ball.tz\n0,1,0,0,0,0,1,0,0,0,0,1,0.5\n1,1,0,0,0,0,1,0,0,0,0,1,0.5\n");
  const auto posed = sessionOf(
      "abstand: 1\ndefaults: {voxel: 0.01, point: 0.01}\nobjects:\n"
      "  - {name: ball, shape: {sphere: {radius: 0.05}}, mass: 1}\n",
      folder_, folder_.path() / "poses.csv");
  ClosedLoop loop(*posed, 0.0);
  EXPECT_EQ(loop.freeThings(), 0u);
  steps(loop, 100);
  EXPECT_EQ(posed->scene().find("ball")->X_WB.translation().z(), 0.5);
}

TEST_F(FallingObjects, RejectOpenSheet) {
  folder_.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto sheet = sessionOf(
      "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\nobjects:\n"
      "  - {name: sheet, mesh: sheet.obj, mass: 1}\n",
      folder_);
  try {
    const ClosedLoop loop(*sheet, 0.0);
    FAIL() << "it falls";
  } catch (const ParseError& e) {
    EXPECT_THAT(e.what(),
                ::testing::HasSubstr("scene.yaml:4:5: error: found a `mass` for 'sheet', whose mesh"));
  }
}

/// A slide of 2 kg that carries a box of 4 cm, held, towards a wall at x = 0.3, as its plan does not know.
std::unique_ptr<session::Session> holding(const testing::ScratchFolder& folder, const std::string& held) {
  folder.write("slide.mech",
               "units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\nend_mapping\nchain\n"
               "frame 1 0 90 d 0\nend_chain\nlimits\nlimit 1 -5 5 10 500\nend_limits\n"
               "inertia\nbody 1 2 0 0 0 0.002 0.002 0.002 0 0 0\nend_inertia\n");
  // A spline through these rings at first, by a quarter less from row to row.
  folder.write("go.csv", "t,q0\n0,0\n1,0.4\n2,0.4\n3,0.4\n4,0.4\n5,0.4\n6,0.4\n7,0.4\n");
  return sessionOf(
      "abstand: 1\ndefaults: {voxel: 0.01, point: 0.01, stiffness: 1.0e6}\nmechanisms:\n"
      "  - name: slide\n    file: slide.mech\n    base: {rpy: [0, 0, 1.5707963267948966]}\n    motion: "
      "go.csv\n"
      "    reaction: {proxy: {stiffness: 500, rotation_stiffness: 10, gap: 0.001}}\n"
      "    links: [{name: box, frame: 1, shape: {cuboid: {size: [0.04, 0.04, 0.04]}}" +
          held +
          "}]\n"
          "objects:\n  - {name: wall, shape: {cuboid: {size: [0.1, 0.4, 0.4]}}, pose: {xyz: [0.35, 0, 0]}}\n",
      folder);
}

TEST(HeldObject, StaysOnSurfaceWhilePressed) {
  const testing::ScratchFolder folder;
  const auto session = holding(folder, ", held: true");
  ClosedLoop loop(*session, 0.0);
  double nearest = kInfinity;
  for (int i = 0; i < 6999; ++i) {
    loop.step();
    nearest = std::min(nearest, session->scene().pairs()[0].result.distance);
  }
  const ReactingRobot& robot = *loop.robots()[0];
  // A cycle sees what the last one left: at 0.6 m/s it may be that much deeper than the gap, not more.
  EXPECT_GT(nearest, 0.0);
  EXPECT_NEAR(session->scene().pairs()[0].result.distance, 0.001, 1e-5) << "the gap";
  // The hand rests between two springs: that of the plan, m omega^2, and that of what it holds, whose surface
  // is at 0.3 - 0.02 - 0.001.
  const double plan = 2.0 * 36.0, surface = 0.279;
  const double hand = (plan * 0.4 + 500.0 * surface) / (plan + 500.0);
  EXPECT_NEAR(robot.q()[0], hand, 1e-4);
  ASSERT_TRUE(robot.held());
  EXPECT_NEAR(robot.held()->wrench().force.x(), -500.0 * (hand - surface), 0.05);
}

TEST(HeldObject, IsOrdinaryLinkWithoutLaw) {
  const testing::ScratchFolder folder;
  EXPECT_THROW(holding(folder, ""), ParseError) << "`proxy`, and nothing to hold";
  const auto session = holding(folder, ", held: true");
  session->step(1.0);
  EXPECT_NEAR(session->scene().find("box")->X_WB.translation().x(), 0.4, 1e-12) << "not reacting: as planned";
  {
    ClosedLoop loop(*session, 0.0);
    steps(loop, 2000);
    EXPECT_LT(session->scene().find("box")->X_WB.translation().x(), 0.28);
  }
  session->step(1.0);
  EXPECT_NEAR(session->scene().find("box")->X_WB.translation().x(), 0.4, 1e-12) << "the loop gave it back";
}

TEST(HeldObject, AllocatesNothing) {
  const testing::ScratchFolder folder;
  const auto session = holding(folder, ", held: true");
  ClosedLoop loop(*session, 0.0);
  steps(loop, 900);
  testing::NoAlloc guard;
  steps(loop, 300);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace things_test
}  // namespace abstand::loop
