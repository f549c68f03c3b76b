#include "tracking/recording/part_joints.hpp"

namespace abstand::tracking {
namespace {

using PartJoint = humanmodel::Joint;
constexpr PartJoint kTorso[]{PartJoint::kPelvis, PartJoint::kSpine, PartJoint::kThorax, PartJoint::kNeck};
constexpr PartJoint kHead[]{PartJoint::kNeck, PartJoint::kHead, PartJoint::kHeadTop};
constexpr PartJoint kBicepsLeft[]{PartJoint::kShoulderLeft, PartJoint::kElbowLeft},
    kBicepsRight[]{PartJoint::kShoulderRight, PartJoint::kElbowRight};
constexpr PartJoint kForearmLeft[]{PartJoint::kElbowLeft, PartJoint::kWristLeft},
    kForearmRight[]{PartJoint::kElbowRight, PartJoint::kWristRight};
constexpr PartJoint kHandLeft[]{PartJoint::kWristLeft, PartJoint::kHandLeft},
    kHandRight[]{PartJoint::kWristRight, PartJoint::kHandRight};
constexpr PartJoint kThighLeft[]{PartJoint::kHipLeft, PartJoint::kKneeLeft},
    kThighRight[]{PartJoint::kHipRight, PartJoint::kKneeRight};
constexpr PartJoint kCalfLeft[]{PartJoint::kKneeLeft, PartJoint::kAnkleLeft},
    kCalfRight[]{PartJoint::kKneeRight, PartJoint::kAnkleRight};
constexpr PartJoint kFootLeft[]{PartJoint::kAnkleLeft, PartJoint::kToeLeft},
    kFootRight[]{PartJoint::kAnkleRight, PartJoint::kToeRight};

constexpr PartJoints kParts[]{{"torso", kTorso},
                              {"head", kHead},
                              {"biceps_left", kBicepsLeft},
                              {"biceps_right", kBicepsRight},
                              {"forearm_left", kForearmLeft},
                              {"forearm_right", kForearmRight},
                              {"hand_left", kHandLeft},
                              {"hand_right", kHandRight},
                              {"thigh_left", kThighLeft},
                              {"thigh_right", kThighRight},
                              {"calf_left", kCalfLeft},
                              {"calf_right", kCalfRight},
                              {"foot_left", kFootLeft},
                              {"foot_right", kFootRight}};

}  // namespace

std::span<const PartJoints> partJoints() { return kParts; }

}  // namespace abstand::tracking
