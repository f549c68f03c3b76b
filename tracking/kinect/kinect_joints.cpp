#include "tracking/kinect/kinect_joints.hpp"

namespace abstand::tracking {
namespace {

const std::array<std::string, 25> kKinectV2{
    "SpineBase",     "SpineMid",    "Neck",      "Head",          "ShoulderLeft",
    "ElbowLeft",     "WristLeft",   "HandLeft",  "ShoulderRight", "ElbowRight",
    "WristRight",    "HandRight",   "HipLeft",   "KneeLeft",      "AnkleLeft",
    "FootLeft",      "HipRight",    "KneeRight", "AnkleRight",    "FootRight",
    "SpineShoulder", "HandTipLeft", "ThumbLeft", "HandTipRight",  "ThumbRight"};

const std::array<std::string, 20> kUtdMhad{"head",           "shoulder_center", "spine",       "hip_center",
                                           "left_shoulder",  "left_elbow",      "left_wrist",  "left_hand",
                                           "right_shoulder", "right_elbow",     "right_wrist", "right_hand",
                                           "left_hip",       "left_knee",       "left_ankle",  "left_foot",
                                           "right_hip",      "right_knee",      "right_ankle", "right_foot"};

const std::array<std::string, 22> kUiPrmd{
    "Waist",       "Spine",       "Chest",       "Neck",        "Head",     "Head tip",
    "L collar",    "L upper arm", "L forearm",   "L hand",      "R collar", "R upper arm",
    "R forearm",   "R hand",      "L upper leg", "L lower leg", "L foot",   "L toes",
    "R upper leg", "R lower leg", "R foot",      "R toes"};

constexpr std::array<int, 22> kUiPrmdParents{-1, 0,  1,  2, 3,  4,  2,  6, 7,  8,  2,
                                             10, 11, 12, 0, 14, 15, 16, 0, 18, 19, 20};

}  // namespace

std::span<const std::string> kinectV2Joints() { return kKinectV2; }
std::span<const std::string> utdMhadJoints() { return kUtdMhad; }
std::span<const std::string> uiPrmdJoints() { return kUiPrmd; }
std::span<const int> uiPrmdParents() { return kUiPrmdParents; }

std::optional<humanmodel::JointState> parseTrackingState(std::string_view word) {
  if (word == "Tracked") return humanmodel::JointState::kTracked;
  if (word == "Inferred") return humanmodel::JointState::kInferred;
  if (word == "NotTracked") return humanmodel::JointState::kMissing;
  return std::nullopt;
}

}  // namespace abstand::tracking
