#include "tracking/tracker/body_follower.hpp"

#include <cmath>

#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

/// Fits a pose to an image without a preference for any posture. Returns its cost.
double refineTurned(const BodyRig& rig, const BodyObservation& seen, RigPose& pose) {
  DepthFit fit(rig);
  DepthFit::Weights weights;
  weights.prior.setConstant(1.0);
  fit.refine(seen, pose, weights, kTurnSteps, pose);
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  return fit.misfit(seen, X_WS).cost;
}

}  // namespace

BodyFollower::BodyFollower(const humanmodel::HumanOptions& options, const Stature& stature,
                           const Facing& facing, std::uint64_t seed)
    : body{options},
      rig{std::make_shared<BodyRig>(makeRig(humanmodel::makeHuman(options)))},
      tracker{std::make_unique<BodyTracker>(*rig, seed)} {
  tracker->setStatureDeviation(stature.deviation());
  tracker->expectAway(facing.away);
  if (facing.lies) tracker->expectLying(facing.away);
  tracker->setFacingKnown(facing.decided());
}

const TrackedBody& BodyFollower::track(double t, std::span<const PersonImage> images) {
  const TrackedBody& found = tracker->track(t, images);
  if (found.found) path.add(t, found.pose);
  return found;
}

void BodyFollower::learn() {
  const TrackedBody& found = tracker->body();
  if (!found.found) return;
  held.see(tracker->seen(), tracker->fit(), found.X_WS, found.visible);
  tracker->widenHands(held.extent());
}

void BodyFollower::continueFrom(const BodyFollower& last) {
  held = last.held;
  path = last.path;
  if (last.tracker->body().found) tracker->resume(last.tracker->body().pose, last.tracker->lying());
}

void BodyFollower::startTurned(const BodyFollower& last) {
  const BodyTracker& other = *last.tracker;
  RigPose turned = flippedFacing(*rig, other.body().pose);
  const double turned_cost = refineTurned(*rig, other.seen(), turned);
  const TrackedBody& searched = tracker->search(other, yawOf(other.body().pose) + kPi);
  const bool is_better = searched.misfit.cost < turned_cost && !faceAlike(searched.pose, other.body().pose);
  tracker->resume(is_better ? searched.pose : turned, {}, other.body().frame.t);
}

}  // namespace abstand::tracking
