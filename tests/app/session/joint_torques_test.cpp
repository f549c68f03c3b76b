// What acts on a joint, where it is known by hand.
#include "app/session/joint_torques.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/paths.hpp"

namespace abstand::session {
namespace joint_torques_test {

constexpr double kG = 9.80665;  // m/s^2

/// A slide along z (prismatic) that carries 2 kg.
MechanismDriver slide(const testing::ScratchFolder& folder, const char* inertia, const char* motion = "") {
  folder.write("slide.mech", std::string("units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\n"
                                         "end_mapping\nchain\nframe 1 0 0 d 0\nend_chain\n") +
                                 inertia);
  scene_file::MechanismDescription d;
  d.name = "slide";
  d.file = folder.path() / "slide.mech";
  if (*motion) {
    folder.write("motion.csv", motion);
    d.motion = folder.path() / "motion.csv";
  }
  return MechanismDriver(d);
}

constexpr const char* kTwoKilograms = "inertia\nbody 1 2 0 0 0 0.002 0.002 0.002 0 0 0\nend_inertia\n";

TEST(JointTorques, AreNegativeWeightAndInertia) {
  const testing::ScratchFolder folder;
  const MechanismDriver driver = slide(folder, kTwoKilograms);
  JointTorques torques(driver);
  std::vector<view::TorqueParts> parts(1);
  const std::vector<double> qd{0.7}, qdd{3.0};
  torques.update(qd, qdd, parts);
  EXPECT_NEAR(parts[0].gravity, -2.0 * kG, 1e-9);
  EXPECT_NEAR(parts[0].motion, -6.0, 1e-9);
}

TEST(JointTorques, RecordedMotionUsesSplineAcceleration) {
  const testing::ScratchFolder folder;
  const MechanismDriver driver = slide(folder, kTwoKilograms, "t,q0\n0,0\n1,0.5\n2,0\n");
  JointTorques torques(driver);
  const mechanism::SmoothMotion spline(*driver.motion());
  std::vector<view::TorqueParts> parts(1);
  double largest = 0.0;
  for (double t = 0.05; t < 2.0; t += 0.1) {
    torques.updateRecorded(t, parts);
    std::vector<double> q(1), qd(1), qdd(1);
    spline.at(t, q, qd, qdd);
    EXPECT_NEAR(parts[0].motion, -2.0 * qdd[0], 1e-9) << t;
    largest = std::max(largest, std::abs(parts[0].motion));
  }
  EXPECT_GT(largest, 1.0);
  torques.updateRecorded(5.0, parts);
  EXPECT_NEAR(parts[0].motion, 0.0, 1e-9) << "at rest after its end";
}

TEST(JointTorques, AreUnknownWithoutMasses) {
  const testing::ScratchFolder folder;
  const MechanismDriver driver = slide(folder, "");
  JointTorques torques(driver);
  std::vector<view::TorqueParts> parts{{1.0, 2.0, 0.0, 0.0}};
  torques.updateRecorded(0.0, parts);
  EXPECT_TRUE(std::isnan(parts[0].gravity));
  EXPECT_TRUE(std::isnan(parts[0].motion));
  EXPECT_EQ(parts[0].contact, 1.0);
  EXPECT_EQ(parts[0].reaction, 2.0);
}

}  // namespace joint_torques_test
}  // namespace abstand::session
