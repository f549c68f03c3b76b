// A pose of a camera, and how well it explains the room that two cameras see.
#include "tracking/depth/calibration/room_candidate.hpp"

#include <cmath>

namespace abstand::tracking {

RoomCandidate judgeRoomPose(const RoomRows& rows, const Transform& X_WC) {
  RoomCandidate c{.X_WC = X_WC, .cost = rows.cost(X_WC)};
  const SurfaceSum sum = rows.at(X_WC, RoomRows::kLastGate, RoomRows::kAllPoints);
  c.points = sum.rows;
  c.rms = std::sqrt(sum.squares / sum.weights);
  c.agreement = rows.agreement(X_WC, RoomRows::kAllPoints, sum);
  const double weakest = c.agreement.weakest;
  const double rms = weakest < kRoomWeak ? c.rms / std::sqrt(weakest) : c.rms;
  c.spread = std::hypot(rms, spreadWithin(covarianceOf(sum), X_WC.translation() - sum.middle));
  return c;
}

bool isAcceptable(const RoomCandidate& candidate) {
  return candidate.points >= kRoomMinPoints && candidate.agreement.agreeing >= kRoomMinAgreeing &&
         candidate.agreement.weakest >= kRoomMinConstraint && candidate.rms <= kRoomMaxRms;
}

}  // namespace abstand::tracking
