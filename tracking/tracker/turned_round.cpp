#include "tracking/tracker/turned_round.hpp"

#include <cmath>
#include <utility>

#include "tracking/body/joint_fit.hpp"

namespace abstand {
namespace {

constexpr std::array<std::pair<Joint, Joint>, 8> kSides{{{Joint::kShoulderLeft, Joint::kShoulderRight},
                                                         {Joint::kElbowLeft, Joint::kElbowRight},
                                                         {Joint::kWristLeft, Joint::kWristRight},
                                                         {Joint::kHandLeft, Joint::kHandRight},
                                                         {Joint::kHipLeft, Joint::kHipRight},
                                                         {Joint::kKneeLeft, Joint::kKneeRight},
                                                         {Joint::kAnkleLeft, Joint::kAnkleRight},
                                                         {Joint::kToeLeft, Joint::kToeRight}}};

}  // namespace

double yawOf(const RigPose& pose) {
  const Vector3d front = pose.X_WP.linear().col(0);
  return std::atan2(front.y(), front.x());
}

RigPose flippedFacing(const BodyRig& rig, const RigPose& pose) {
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  SkeletonFrame frame;
  jointsOf(rig, X_WS, JointState::kTracked, frame);
  for (const auto& [left, right] : kSides)
    std::swap(frame.p[static_cast<std::size_t>(left)], frame.p[static_cast<std::size_t>(right)]);
  for (const auto& [ankle, toe] :
       {std::pair{Joint::kAnkleLeft, Joint::kToeLeft}, {Joint::kAnkleRight, Joint::kToeRight}}) {
    Vector3d foot = frame[toe] - frame[ankle];
    foot.head<2>() *= -1.0;
    frame.set(toe, frame[ankle] + foot);
  }
  return fitJoints(rig, frame, startAt(frame)).pose;
}

}  // namespace abstand
