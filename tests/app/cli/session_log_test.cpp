// The log of `abstand run --session` (docs/session-log.md), read back.
#include "app/run/session_log.hpp"
#include "app/hdf5/table_reader.hpp"
#include "core/base/error.hpp"
#include "tests/app/ball_and_wall.hpp"
#include "tests/app/program.hpp"

namespace abstand::testing {
namespace session_log_test {

/// A ball flies at a wall at 1 m/s, along -x, and stands still 2 mm inside the wall's margin.
class SessionLogTest : public Cli {
 protected:
  static constexpr std::size_t kFrames = 101, kBall = 1;
  // Times of the poses file have six digits, and a frame takes 10 ms.
  static constexpr double kSpeedError = 1e-3;

  SessionLogTest() {
    scene_ = folder_.write("ball.yaml", kMarginScene).string();
    runJson("run " + scene_ + " --poses " + folder_.write("m.csv", ballPoses(0.018)).string() +
            " --session " + log());
  }
  std::string log() const { return (folder_.path() / "run.h5").string(); }

  static constexpr const char* kMarginScene = R"(abstand: 1
defaults: {voxel: 0.005, point: 0.005}
objects:
  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-0.1, 0, 0]}}
  - {name: ball, shape: {sphere: {radius: 0.05}}, margin: 0.02}
)";
  std::string scene_;
};

TEST_F(SessionLogTest, HoldsPosesAndVelocities) {
  const hdf5::TableReader in(log());
  EXPECT_EQ(in.integer("abstand"), run::SessionLog::kFormat);
  EXPECT_FALSE(in.text("version").empty());
  EXPECT_EQ(in.texts("objects"), (std::vector<std::string>{"wall", "ball"}));
  const std::vector<std::string> inputs = in.texts("inputs");
  ASSERT_EQ(inputs.size(), 1u);
  EXPECT_NE(inputs[0].find("ball.yaml"), std::string::npos);
  EXPECT_EQ(inputs[0].find("  "), 32u) << "a fingerprint of 128 bits";
  const std::vector<double> t = in.table("t", kFrames, 1), pose = in.table("pose", kFrames, 14),
                            velocity = in.table("velocity", kFrames, 12),
                            mean = in.table("mean_velocity", kFrames, 12),
                            state = in.table("pose_state", kFrames, 2);
  for (std::size_t i = 0; i < kFrames; ++i) {
    SCOPED_TRACE(t[i]);
    const double* ball = &pose[14 * i + 7 * kBall];
    EXPECT_NEAR(ball[0], std::max(1.0 - t[i], 0.018) + 0.05, 1e-6);
    EXPECT_EQ(ball[3], 1.0);
    EXPECT_EQ(velocity[12 * i], 0.0) << "the wall";
    EXPECT_EQ(state[2 * i + kBall], 0.0);
    if (i == 0) continue;
    const double before = pose[14 * (i - 1) + 7 * kBall];
    EXPECT_NEAR(velocity[12 * i + 6 * kBall], (ball[0] - before) / (t[i] - t[i - 1]), kSpeedError);
    // Over the last ten poses, fewer at the beginning.
    const std::size_t first = i >= 9 ? i - 9 : 0;
    const double way = ball[0] - pose[14 * first + 7 * kBall];
    EXPECT_NEAR(mean[12 * i + 6 * kBall], way / (t[i] - t[first]), kSpeedError);
  }
}

TEST_F(SessionLogTest, HoldsDistancesAndContacts) {
  const hdf5::TableReader in(log());
  const std::vector<double> t = in.table("t", kFrames, 1), distance = in.table("distance", kFrames, 1),
                            bound = in.table("bound", kFrames, 1), points = in.table("points", kFrames, 6),
                            force = in.table("force", kFrames, 3),
                            contacts = in.table("contacts", kFrames, 1),
                            on_objects = in.table("contact_force", kFrames, 12),
                            of_objects = in.table("object_contacts", kFrames, 2);
  bool touched = false;
  for (std::size_t i = 0; i < kFrames; ++i) {
    SCOPED_TRACE(t[i]);
    const double truth = std::max(1.0 - t[i], 0.018);
    EXPECT_LE(distance[i] - bound[i], truth + 1e-9);
    EXPECT_NEAR(distance[i], truth, 0.01 * truth);
    EXPECT_EQ(std::isnan(points[6 * i]), !(distance[i] < run::SessionLog::kPointsWithin));
    if (!std::isnan(points[6 * i])) {
      double squared = 0.0;
      for (std::size_t k = 0; k < 3; ++k) squared += std::pow(points[6 * i + 3 + k] - points[6 * i + k], 2);
      EXPECT_NEAR(std::sqrt(squared), distance[i], 5e-6) << "whole micrometres";
    }
    const bool inside = truth < 0.02 - 1e-6;
    EXPECT_EQ(contacts[i] > 0.0, inside);
    EXPECT_EQ(of_objects[2 * i], contacts[i]);
    EXPECT_EQ(of_objects[2 * i + 1], contacts[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      // One pair: what acts on the wall is the pair's force, what acts on the ball the opposite.
      EXPECT_EQ(on_objects[12 * i + k], force[3 * i + k]);
      EXPECT_EQ(on_objects[12 * i + 6 + k], -force[3 * i + k]);
    }
    EXPECT_EQ(force[3 * i] < 0.0, inside) << "pushes the wall along -x";
    touched = touched || inside;
  }
  EXPECT_TRUE(touched);
}

TEST_F(SessionLogTest, RejectsDamagedFile) {
  std::string bytes = readFile(log(), 1 << 30);
  EXPECT_EQ(bytes.substr(512, 8), "\x89HDF\r\n\x1a\n") << "readers of HDF5 look for it there";
  bytes[bytes.size() / 2] ^= 1;
  EXPECT_THROW(hdf5::TableReader(folder_.write("damaged.h5", bytes)), ParseError);
}

}  // namespace session_log_test
}  // namespace abstand::testing
