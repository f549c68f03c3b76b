#include "tracking/tracker/turned_round.hpp"

#include <cmath>
#include <utility>

#include "tracking/body/joint_fit.hpp"

namespace abstand::tracking {
namespace {

constexpr double kLevelFront = 0.7;  // cosine; the front of a person who lies points up or down

constexpr std::array<std::pair<humanmodel::Joint, humanmodel::Joint>, 8> kSides{
    {{humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kShoulderRight},
     {humanmodel::Joint::kElbowLeft, humanmodel::Joint::kElbowRight},
     {humanmodel::Joint::kWristLeft, humanmodel::Joint::kWristRight},
     {humanmodel::Joint::kHandLeft, humanmodel::Joint::kHandRight},
     {humanmodel::Joint::kHipLeft, humanmodel::Joint::kHipRight},
     {humanmodel::Joint::kKneeLeft, humanmodel::Joint::kKneeRight},
     {humanmodel::Joint::kAnkleLeft, humanmodel::Joint::kAnkleRight},
     {humanmodel::Joint::kToeLeft, humanmodel::Joint::kToeRight}}};

}  // namespace

bool facesUpOrDown(const Vector3d& front) { return std::abs(front.z()) >= kLevelFront * front.norm(); }

double yawOf(const RigPose& pose) {
  const Vector3d front = pose.X_WP.linear().col(0);
  return std::atan2(front.y(), front.x());
}

bool faceAlike(const RigPose& a, const RigPose& b) { return std::cos(yawOf(a) - yawOf(b)) > 0.5; }

humanmodel::Joint mirrored(humanmodel::Joint joint) {
  for (const auto& [left, right] : kSides) {
    if (joint == left) return right;
    if (joint == right) return left;
  }
  return joint;
}

humanmodel::SkeletonFrame flippedFacing(const humanmodel::SkeletonFrame& frame) {
  humanmodel::SkeletonFrame other = frame;
  for (const auto& [left, right] : kSides)
    std::swap(other.p[static_cast<std::size_t>(left)], other.p[static_cast<std::size_t>(right)]);
  using enum humanmodel::Joint;
  const Vector3d front = (frame[kHipLeft] - frame[kHipRight]).cross(frame[kNeck] - frame[kPelvis]);
  for (const auto& [ankle, toe] : {std::pair{humanmodel::Joint::kAnkleLeft, humanmodel::Joint::kToeLeft},
                                   {humanmodel::Joint::kAnkleRight, humanmodel::Joint::kToeRight}}) {
    Vector3d foot = other[toe] - other[ankle];
    if (facesUpOrDown(front))
      foot -= 2.0 * front.dot(foot) / front.squaredNorm() * front;
    else
      foot.head<2>() *= -1.0;
    other.p[static_cast<std::size_t>(toe)] = other[ankle] + foot;
  }
  return other;
}

RigPose flippedFacing(const BodyRig& rig, const RigPose& pose) {
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  humanmodel::SkeletonFrame frame;
  jointsOf(rig, X_WS, humanmodel::JointState::kTracked, frame);
  frame = flippedFacing(frame);
  return fitJoints(rig, frame, startAt(frame)).pose;
}

}  // namespace abstand::tracking
