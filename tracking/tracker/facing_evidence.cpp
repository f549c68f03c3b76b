#include "tracking/tracker/facing_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tracking/tracker/leg_posture.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {

FacingEvidence facingEvidence(const BodyTracker& tracker) {
  const TrackedBody& body = tracker.body();
  const SeenPoints& points = tracker.seen().points();
  std::array<float, SeenPoints::kMax> score;
  tracker.fit().scores(points, body.X_WS, DepthFit::kAll, score.data());
  std::size_t low = 0;  // their scores are moved to the front
  for (std::size_t i = 0; i < points.count; ++i)
    if (static_cast<double>(points.z[i]) < FacingEvidence::kLow) score[low++] = score[i];
  FacingEvidence evidence;
  evidence.cost = body.misfit.cost;
  evidence.low_points = static_cast<double>(low);
  evidence.low_cost = evidence.low_points * DepthFit::robustMean(score.data(), low);
  evidence.empty_cost =
      tracker.fit().placeCost(tracker.seen(), body.X_WS,
                              DepthFit::bit(RigSegment::kFootLeft) | DepthFit::bit(RigSegment::kFootRight));
  evidence.kneels = kneels(body.X_WS);
  evidence.shows_little = tracker.isCutAtBothEnds() || tracker.isBent();
  evidence.p_WP = body.pose.X_WP.translation();
  evidence.distance = kInfinity;
  for (const BodyView& view : tracker.seen().views())
    evidence.distance = std::min(evidence.distance, (evidence.p_WP - view.eye()).norm());
  const double yaw = yawOf(body.pose);
  evidence.forward_W = {std::cos(yaw), std::sin(yaw), 0.0};
  return evidence;
}

}  // namespace abstand::tracking
