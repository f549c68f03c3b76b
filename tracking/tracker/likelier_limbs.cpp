// Limbs of a tracked body that a fit has exchanged or raised.
#include <algorithm>

#include "tracking/tracker/body_tracker.hpp"
#include "tracking/tracker/crossed_limbs.hpp"
#include "tracking/tracker/leg_posture.hpp"
#include "tracking/tracker/raised_arms.hpp"
#include "tracking/tracker/seen_segments.hpp"

namespace abstand::tracking {
namespace {

// Times the cost of crossed limbs or of a raised leg, at which other limbs are still the likelier ones.
constexpr double kLikelierCost = 1.1;
// The same of a raised arm whose forearm is hidden. Upper arms that explained the neck had 1.2 to 1.6, those
// of hands behind the head at least 2.7; with 2.0, somebody who boxes lost an arm more often.
constexpr double kHangingCost = 1.6;
// Points that a forearm may explain alone beside a leg that explains the rest of it.
constexpr double kShared = 4.0;

/// Whether forearm and hand each explain fewer points alone.
bool isForearmHidden(const TrackedBody& body, const Limb& arm, double points = kSupported) {
  return std::max(body.support[index(arm.lower)], body.support[index(arm.end)]) < points;
}

}  // namespace

/// Legs that a fit has exchanged; while a person is followed, crossed legs are those of somebody who walks.
void BodyTracker::uncrossLegs() {
  if (crossesLegs(body_.X_WS)) tryLikelier(uncrossedLegs(*rig_, body_.pose, body_.X_WS), kLikelierCost);
}

/// Legs that a fit has raised where the arms are, as of somebody of whom nothing else is seen above a bench.
/// Those of somebody who sits on a table explain points that nothing else does.
void BodyTracker::standLegs() {
  if (!floats()) return;
  RigPose start = standingLegs(*rig_, body_.pose, body_.X_WS);
  for (std::size_t k = 0; k < kLimbs.size(); ++k)
    if (kLimbs[k].isArm()) limbs_.search(seen_, k, {120, 0.3, 1.0, false}, random_, start);
  if (tryLikelier(start, kFloats)) velocity_.setZero();
}

/// Arms that a fit has exchanged, as when they are raised above the head within a few images. Not of people
/// who lie: from above, arms beside the head of somebody on the front look alike either way.
void BodyTracker::uncrossArms() {
  if (lying_.lies || !crossesArms(body_.X_WS)) return;
  if (tryLikelier(uncrossedArms(*rig_, body_.pose, body_.X_WS), kLikelierCost)) velocity_.setZero();
}

/// A hidden leg that was raised, and explains points of an arm that explains few alone. Where a leg is raised
/// indeed, no arm explains its points as well.
void BodyTracker::lowerLeg() {
  const std::optional<std::size_t> leg = raisedLeg(body_.X_WS);
  if (!leg || lying_.lies) return;
  fit_.support(seen_, body_.X_WS, body_.support);
  const std::array<bool, 2> hidden{isForearmHidden(body_, kLimbs[0], kShared),
                                   isForearmHidden(body_, kLimbs[1], kShared)};
  if (!hidden[0] && !hidden[1]) return;
  RigPose start = loweredLeg(*rig_, body_.pose, body_.X_WS, *leg);
  for (std::size_t k = 0; k < hidden.size(); ++k)
    if (hidden[k]) limbs_.search(seen_, k, {120, 0.3, 1.0, false}, random_, start);
  if (tryLikelier(start, kLikelierCost)) velocity_.setZero();
}

/// A leg that a fit has folded where the images end, as of somebody who squats close to a camera: the foot is
/// below the hip.
void BodyTracker::plantLegs() {
  if (lying_.lies) return;
  for (std::size_t k = 0; k < kLimbs.size(); ++k) {
    if (kLimbs[k].isArm()) continue;
    const std::optional<RigPose> planted = plantedLeg(*rig_, body_.pose, body_.X_WS, k);
    if (!planted) continue;
    RigPlacement X_WS;
    place(*rig_, *planted, X_WS);
    if (isInView(X_WS[index(kLimbs[k].end)].translation())) continue;
    if (tryLikelier(*planted, kLikelierCost)) velocity_.setZero();
  }
}

/// An arm that was raised and whose forearm is hidden: the upper arm may explain points of the neck or the
/// head that their shapes do not.
void BodyTracker::lowerArms() {
  for (std::size_t k = 0; k < kLimbs.size(); ++k) {
    const Limb& arm = kLimbs[k];
    if (lying_.lies || !arm.isArm() || !isRaised(body_.X_WS, arm)) continue;
    fit_.support(seen_, body_.X_WS, body_.support);
    if (!isForearmHidden(body_, arm)) continue;
    const RigPose hanging = hangingArm(*rig_, body_.pose, body_.X_WS, arm);
    if (limbs_.cost(seen_, k, hanging) > kHangingCost * limbs_.cost(seen_, k, body_.pose)) continue;
    if (tryLikelier(hanging, kHangingCost)) velocity_.setZero();
  }
}

/// Fits from `start`, a likelier pose, unless the image then costs more than `limit` times as much. Returns
/// whether the pose changed.
bool BodyTracker::tryLikelier(const RigPose& start, double limit) {
  const TrackedBody before = body_;
  body_.pose = start;
  fit_.refine(seen_, body_.pose, wide_, kStartWideSteps, body_.pose);
  fit_.refine(seen_, body_.pose, narrow_, kStartNarrowSteps, body_.pose);
  placeBody();
  if (body_.misfit.cost <= limit * before.misfit.cost) return true;
  body_ = before;
  return false;
}

}  // namespace abstand::tracking
