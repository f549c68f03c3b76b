#include "tracking/tracker/other_posture.hpp"

#include <algorithm>

namespace abstand::tracking {
namespace {

constexpr double kUprightShare = 0.96;  // of the stature, between sole and vertex of who stands upright
constexpr double kUnderVertex = 0.05;   // m; hands that are higher may be the highest of the person
// m: who is higher and does not stand upright would be taller than anybody, or sits on a table.
constexpr double kTallestLowered = 1.85;

}  // namespace

std::vector<OtherPosture> otherPostures(const Stature& stature) {
  using enum OtherPosture::Kind;
  const double seen = stature.seen;
  if (!stature.known()) {
    if (seen >= Stature::kShortest && seen < Stature::kShortestUpright)
      return {{kChild, Stature::ofChild(seen)}};
    return {};
  }
  std::vector<OtherPosture> others;
  if (seen <= Stature::kTallestSeated) {
    others.push_back({kSeated, Stature::ofSeated(seen)});
    others.push_back({kKneeling, Stature::ofKneeling(seen)});
  }
  if (seen <= kTallestLowered) others.push_back({kLowered, Stature::ofLowered(seen)});
  others.push_back({kRaisedArms, Stature::ofRaisedArms(seen)});
  return others;
}

namespace {

/// Between sole and vertex, whatever the arms do.
bool isStretched(const humanmodel::SkeletonFrame& frame, const BodyRig& rig) {
  return frame[humanmodel::Joint::kHeadTop].z() - lowestFoot(frame) > kUprightShare * rig.height;
}

}  // namespace

bool isIn(OtherPosture::Kind kind, const humanmodel::SkeletonFrame& frame, const BodyRig& rig) {
  if (kind == OtherPosture::Kind::kRaisedArms) return raisesHands(frame);
  return kind != OtherPosture::Kind::kChild || isStretched(frame, rig);
}

double lowestFoot(const humanmodel::SkeletonFrame& frame) {
  using enum humanmodel::Joint;
  return std::min({frame[kAnkleLeft].z(), frame[kAnkleRight].z(), frame[kToeLeft].z(), frame[kToeRight].z()});
}

bool standsUpright(const humanmodel::SkeletonFrame& frame, const BodyRig& rig) {
  return isStretched(frame, rig) && !raisesHands(frame);
}

bool raisesHands(const humanmodel::SkeletonFrame& frame) {
  using enum humanmodel::Joint;
  return std::max({frame[kHandLeft].z(), frame[kHandRight].z(), frame[kWristLeft].z(),
                   frame[kWristRight].z()}) > frame[kHeadTop].z() - kUnderVertex;
}

}  // namespace abstand::tracking
