// One and the same movement, exported over three rest poses, gives one and the same body.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/base/number.hpp"
#include "core/math/turn_between.hpp"
#include "tracking/bvh/bvh_recording.hpp"

namespace abstand::tracking {
namespace rest_pose_test {

/// A bone of the export: where its joint lies in the rest pose and in the movement's first frame, from its
/// parent.
struct Bone {
  int depth;
  const char* name;  // nullptr: end site
  Vector3d rest, moved;
};

Vector3d degreesZxy(const Matrix3d& R) {
  return Vector3d(std::atan2(-R(0, 1), R(1, 1)), std::asin(R(2, 1)), std::atan2(-R(2, 0), R(2, 2))) * 180.0 /
         kPi;
}

/// cm, z up, facing x. Arms leave the shoulders, and legs the hips, by these degrees from straight down.
std::vector<Bone> person(double arms, double legs) {
  std::vector<Bone> list{{0, "Hips", {0, 0, 0}, {0, 0, 0}},
                         {1, "Chest", {0, 0, 25}, {0, 0, 25}},
                         {2, "Neck", {0, 0, 25}, {0, 0, 25}},
                         {3, "Head", {0, 0, 10}, {0, 0, 10}},
                         {4, nullptr, {0, 0, 20}, {0, 0, 20}}};
  const auto limb = [&](double side, double degrees, double length) {
    const double a = degrees * kPi / 180.0;
    return Vector3d(0, side * length * std::sin(a), -length * std::cos(a));
  };
  for (const double side : {1.0, -1.0}) {
    const bool left = side > 0.0;
    list.push_back({2, left ? "LeftCollar" : "RightCollar", {0, 0, 20}, {0, 0, 20}});
    list.push_back({3, left ? "LeftShoulder" : "RightShoulder", {0, side * 20, 0}, {0, side * 20, 0}});
    list.push_back({4, left ? "LeftElbow" : "RightElbow", limb(side, arms, 30), {18, 0, -24}});
    list.push_back({5, left ? "LeftWrist" : "RightWrist", limb(side, arms, 25), {20, 0, 15}});
    list.push_back({6, nullptr, limb(side, arms, 18), {18, 0, 0}});
  }
  for (const double side : {1.0, -1.0}) {
    const bool left = side > 0.0;
    list.push_back({1, left ? "LeftHip" : "RightHip", {0, side * 10, 0}, {0, side * 10, 0}});
    list.push_back({2, left ? "LeftKnee" : "RightKnee", limb(side, legs, 42), {25.2, 0, -33.6}});
    list.push_back({3, left ? "LeftAnkle" : "RightAnkle", limb(side, legs, 44), {0, 0, -44}});
    list.push_back({4, nullptr, {18, 0, -6}, {18, 0, -6}});
  }
  return list;
}

/// Joints with one child are turned so that it comes to where the movement has it.
std::string bvhOf(const std::vector<Bone>& bones) {
  std::string text = "HIERARCHY\n", numbers = "0 0 95";
  std::vector<Matrix3d> R_W{Matrix3d::Identity()};  // of the joints that are open, by depth
  int open = 0;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const Bone& b = bones[i];
    for (; open > b.depth; --open) text += "}\n";
    text += !b.name ? std::string("End Site\n{\n")
                    : (open == 0 ? "ROOT " : "JOINT ") + std::string(b.name) + "\n{\n";
    text += "OFFSET " + formatDouble(b.rest.x()) + " " + formatDouble(b.rest.y()) + " " +
            formatDouble(b.rest.z()) + "\n";
    ++open;
    if (!b.name) continue;
    text += open == 1 ? "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
                      : "CHANNELS 3 Zrotation Xrotation Yrotation\n";
    R_W.resize(static_cast<std::size_t>(b.depth) + 1, Matrix3d::Identity());
    const Bone& child = bones[i + 1];
    const bool is_limb = b.depth >= 1 && child.depth == b.depth + 1;
    const Matrix3d own =
        is_limb ? turnBetween(child.rest, child.moved).toRotationMatrix() : Matrix3d(Matrix3d::Identity());
    const Matrix3d R =
        b.depth == 0 ? own : Matrix3d(R_W[static_cast<std::size_t>(b.depth) - 1].transpose() * own);
    R_W[static_cast<std::size_t>(b.depth)] = own;
    const Vector3d d = degreesZxy(R);
    numbers += " " + formatDouble(d.x()) + " " + formatDouble(d.y()) + " " + formatDouble(d.z());
  }
  for (; open > 0; --open) text += "}\n";
  return text + "MOTION\nFrames: 1\nFrame Time: 0.01\n" + numbers + "\n";
}

TEST(RestPose, TPoseAPoseAndCmuGiveSameBody) {
  const Recording t_pose = readBvhRecording(bvhOf(person(90, 0)), "t.bvh", {});
  ASSERT_EQ(t_pose.report.mapped.size(), 14u);
  EXPECT_NEAR(
      (t_pose.frames[0][humanmodel::Joint::kElbowLeft] - t_pose.frames[0][humanmodel::Joint::kShoulderLeft])
          .x(),
      0.18, 1e-9)
      << "the movement, not the rest pose";
  for (const auto& [arms, legs] : {std::pair{45.0, 0.0}, {90.0, 20.0}, {0.0, 0.0}}) {
    const Recording other = readBvhRecording(bvhOf(person(arms, legs)), "o.bvh", {});
    EXPECT_EQ(other.report.units.name, t_pose.report.units.name);
    EXPECT_EQ(other.report.up.axis, t_pose.report.up.axis);
    EXPECT_NEAR(other.report.stature, t_pose.report.stature, 1e-9);
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      EXPECT_LT((other.frames[0].p[j] - t_pose.frames[0].p[j]).norm(), 1e-9)
          << humanmodel::jointName(static_cast<humanmodel::Joint>(j)) << " at " << arms;
  }
}

}  // namespace rest_pose_test
}  // namespace abstand::tracking
