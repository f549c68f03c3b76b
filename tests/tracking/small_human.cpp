#include "tests/tracking/small_human.hpp"

#include <cmath>
#include <vector>

#include "core/base/number.hpp"

namespace abstand::testing {
namespace {

struct Bone {
  int depth;
  const char* name;  // nullptr: end site
  Vector3d offset;   // m, z up, facing x, left y
};

std::vector<Bone> bones() {
  std::vector<Bone> list{{0, "Hips", {0, 0, 0}},
                         {1, "Chest", {0, 0, 0.25}},
                         {2, "Neck", {0, 0, 0.25}},
                         {3, "Head", {0, 0, 0.10}},
                         {4, nullptr, {0, 0, 0.20}}};
  for (const double side : {1.0, -1.0}) {
    const bool left = side > 0.0;
    list.push_back({2, left ? "LeftCollar" : "RightCollar", {0, 0, 0.20}});
    list.push_back({3, left ? "LeftShoulder" : "RightShoulder", {0, side * 0.2, 0}});
    list.push_back({4, left ? "LeftElbow" : "RightElbow", {0, 0, -0.30}});
    list.push_back({5, left ? "LeftWrist" : "RightWrist", {0, 0, -0.25}});
    list.push_back({6, nullptr, {0, 0, -0.18}});
  }
  for (const double side : {1.0, -1.0}) {
    const bool left = side > 0.0;
    list.push_back({1, left ? "LeftHip" : "RightHip", {0, side * 0.1, 0}});
    list.push_back({2, left ? "LeftKnee" : "RightKnee", {0, 0, -0.42}});
    list.push_back({3, left ? "LeftAnkle" : "RightAnkle", {0, 0, -0.44}});
    list.push_back({4, nullptr, {0.18, 0, -0.06}});
  }
  return list;
}

std::string numbers(const Vector3d& v) {
  return formatDouble(v.x()) + " " + formatDouble(v.y()) + " " + formatDouble(v.z());
}

/// Degrees about z, x, y with R = Rz Rx Ry.
Vector3d zxyDegrees(const Matrix3d& R) {
  return Vector3d(std::atan2(-R(0, 1), R(1, 1)), std::asin(R(2, 1)), std::atan2(-R(2, 0), R(2, 2))) * 180.0 /
         kPi;
}

}  // namespace

std::string bvhOf(const SmallHuman& human) {
  const auto inFile = [&](const Vector3d& p_W) {
    return Vector3d(human.units_per_metre * (human.R_FW * p_W));
  };
  std::string text = "HIERARCHY\n";
  int open = 0;
  std::string turns;
  for (const Bone& bone : bones()) {
    for (; open > bone.depth; --open) text += "}\n";
    if (bone.name)
      text += std::string(open == 0 ? "ROOT " : "JOINT ") + human.rename(bone.name) + "\n{\n";
    else
      text += "End Site\n{\n";
    text += "OFFSET " + numbers(inFile(bone.offset)) + "\n";
    if (open == 0)
      text += "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n";
    else if (bone.name)
      text += "CHANNELS 3 Zrotation Xrotation Yrotation\n";
    if (bone.name) {
      const auto found = human.turned.find(bone.name);
      const Matrix3d R = found == human.turned.end() ? Matrix3d::Identity() : found->second;
      const Matrix3d R_W = open == 0 ? Matrix3d(human.R_WB * R) : R;
      turns += " " + numbers(zxyDegrees(human.R_FW * R_W * human.R_FW.transpose()));
    }
    ++open;
  }
  for (; open > 0; --open) text += "}\n";
  text += "MOTION\nFrames: " + std::to_string(human.frames) + "\nFrame Time: 0.01\n";
  for (int i = 0; i < human.frames; ++i) {
    text += numbers(inFile({0.01 * i, 0.0, human.pelvis_height})) + turns + "\n";
  }
  return text;
}

}  // namespace abstand::testing
