#include "tracking/part_joints.hpp"

namespace abstand {
namespace {

using J = Joint;
constexpr J kTorso[]{J::kPelvis, J::kSpine, J::kThorax, J::kNeck};
constexpr J kHead[]{J::kNeck, J::kHead, J::kHeadTop};
constexpr J kBicepsLeft[]{J::kShoulderLeft, J::kElbowLeft}, kBicepsRight[]{J::kShoulderRight, J::kElbowRight};
constexpr J kForearmLeft[]{J::kElbowLeft, J::kWristLeft}, kForearmRight[]{J::kElbowRight, J::kWristRight};
constexpr J kHandLeft[]{J::kWristLeft, J::kHandLeft}, kHandRight[]{J::kWristRight, J::kHandRight};
constexpr J kThighLeft[]{J::kHipLeft, J::kKneeLeft}, kThighRight[]{J::kHipRight, J::kKneeRight};
constexpr J kCalfLeft[]{J::kKneeLeft, J::kAnkleLeft}, kCalfRight[]{J::kKneeRight, J::kAnkleRight};
constexpr J kFootLeft[]{J::kAnkleLeft, J::kToeLeft}, kFootRight[]{J::kAnkleRight, J::kToeRight};

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

}  // namespace abstand
