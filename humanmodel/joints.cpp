#include "humanmodel/joints.hpp"

namespace abstand::humanmodel {
namespace {

constexpr std::array<std::string_view, kJointCount> kJointNames{
    "pelvis",        "spine",      "thorax",      "neck",      "head",           "head_top",
    "shoulder_left", "elbow_left", "wrist_left",  "hand_left", "shoulder_right", "elbow_right",
    "wrist_right",   "hand_right", "hip_left",    "knee_left", "ankle_left",     "toe_left",
    "hip_right",     "knee_right", "ankle_right", "toe_right"};

}  // namespace

std::string_view jointName(Joint joint) { return kJointNames[static_cast<std::size_t>(joint)]; }

std::optional<Joint> parseJoint(std::string_view name) {
  for (std::size_t i = 0; i < kJointCount; ++i)
    if (kJointNames[i] == name) return static_cast<Joint>(i);
  return std::nullopt;
}

}  // namespace abstand::humanmodel
