// The initial search of a body, from several postures.
#include <cmath>

#include "tracking/tracker/bent_start.hpp"
#include "tracking/tracker/body_tracker.hpp"
#include "tracking/tracker/head_peak.hpp"
#include "tracking/tracker/leg_posture.hpp"
#include "tracking/tracker/raised_arms.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

constexpr double kFoundAbove = 0.7;  // explained share
const std::array<StartPosture, 2> kHighStarts{{{0.0, false}, {0.25, false}}};
constexpr double kRaisedWrists = 0.42;  // m above the shoulders
/// Upright, with raised arms, straight or bent, or with one of them.
const std::array<StartPosture, 4> kRaisedStarts{
    {{0.0, false, Vector3d::Zero(), 0.50},
     {0.0, false, Vector3d::Zero(), 0.35},
     {0.0, false, Vector3d::Zero(), kRaisedWrists, {true, false}},
     {0.0, false, Vector3d::Zero(), kRaisedWrists, {false, true}}}};
/// A hand above a head that is seen.
constexpr std::array<std::array<bool, 2>, 3> kRaisedHands{{{true, false}, {false, true}, {true, true}}};
constexpr double kHandsHighest = 0.08;  // m above the vertex: the highest point is not the head
/// Upright, the head above the image, which cuts it off at the neck or at the forehead.
const std::array<StartPosture, 2> kCutStarts{{{-0.24, false}, {-0.12, false}}};
/// Upright on the floor, or bowed, cut off anywhere.
const std::array<StartPosture, 2> kOnFloorStarts{{{0.0, false}, {0.12, false}}};
/// Bowed; seated; on the knees.
const std::array<StartPosture, 3> kLowStarts{
    {{0.25, false}, {0.0, true, {0.43, 0.0, -0.42}}, {0.0, true, {-0.38, 0.0, -0.38}}}};

void bendLegs(const BodyRig& rig, const Vector3d& p_ankle, RigPose& pose) {
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  for (const Limb& leg : {kLimbs[2], kLimbs[3]}) {
    const Vector3d hip = X_WS[0] * rig[leg.upper].p_parent;
    reachFor(rig, leg, X_WS, hip + X_WS[0].linear() * p_ankle, 0.0, pose);
  }
}

}  // namespace

void BodyTracker::find() {
  wide_.planted = narrow_.planted = 0;
  wide_.untwist = narrow_.untwist = 0.0;
  lying_ = {};
  fit_.keepAboveFloor(false);
  const SeenPoints& points = seen_.points();
  std::array<Vector3d, BodyObservation::kMaxViews> mean;
  std::array<double, BodyObservation::kMaxViews> count{};
  mean.fill(Vector3d::Zero());
  double top = -kInfinity;
  for (std::size_t i = 0; i < points.count; ++i) {
    mean[points.view[i]] += points.point(i);
    count[points.view[i]] += 1.0;
    top = std::max(top, static_cast<double>(points.z[i]));
  }
  // The middle of the body lies behind what each camera sees of it.
  Vector3d middle = Vector3d::Zero();
  std::array<double, BodyObservation::kMaxViews> towards{};
  double views = 0.0;
  for (std::size_t v = 0; v < seen_.views().size(); ++v) {
    if (count[v] == 0.0) continue;
    mean[v] /= count[v];
    Vector3d away = mean[v] - seen_.views()[v].eye();
    away.z() = 0.0;
    if (away.norm() < 1e-6) away = Vector3d::UnitX();
    away.normalize();
    middle += mean[v] + kHalfBody * away;
    towards[v] = std::atan2(-away.y(), -away.x());
    views += 1.0;
  }
  middle /= views;
  Fits fits{{}, kInfinity, AlikeFits(*rig_)};
  if (top < kLyingTop) {
    tryLying(middle, fits.best);
  } else if (front_) {
    tryStarts(middle, top, *front_, fits);
  } else {
    for (std::size_t v = 0; v < seen_.views().size(); ++v)
      if (count[v] > 0.0) tryStarts(middle, top, towards[v] + (expected_.away ? kPi : 0.0), fits);
    if (expected_.yaw) tryStarts(middle, top, *expected_.yaw, fits);
  }
  if (!lying_.lies && top < kHandsOffFloor * rig_->height) lying_.apart = fits.all.apart();
  body_ = fits.best;
  if (std::isfinite(body_.misfit.cost))
    standLegs(), uncrossLegs(), uncrossArms(), lowerLeg(), plantLegs(), lowerArms();
  body_.found = body_.misfit.explained > kFoundAbove;
  velocity_.setZero();
  badly_ = 0;
  limbs_.forgetTries();
}

/// Fits the postures of a start that faces `facing` (rad), about the middle of the body, its highest point at
/// z = `top` (m); keeps the best of these and of `fits`.
void BodyTracker::tryStarts(const Vector3d& middle, double top, double facing, Fits& fits) {
  const double above = vertexAbovePelvis(*rig_);
  const bool is_low = top < kStandingHead * rig_->height;
  const std::span<const StartPosture> postures =
      is_low ? std::span<const StartPosture>(kLowStarts) : std::span<const StartPosture>(kHighStarts);
  tryPostures(postures, middle, top - above, facing, fits);
  if (top > rig_->height + kHandsHighest)
    tryPostures(kRaisedStarts, middle, rig_->height - above, facing, fits);
  if (top < kHandsOffFloor * rig_->height) tryBent(middle, top, facing, fits);
  if (const std::optional<double> head = headBelowHands(seen_)) tryRaised(middle, *head, facing, fits);
  if (!is_cut_.above) return;
  tryPostures(kCutStarts, middle, top - above, facing, fits);
  if (top < rig_->height) tryPostures(kOnFloorStarts, middle, rig_->height - above, facing, fits);
}

/// Of a person whose vertex is at z = `head` (m), below the hands.
void BodyTracker::tryRaised(const Vector3d& middle, double head, double facing, Fits& fits) {
  const double pelvis = head - vertexAbovePelvis(*rig_);
  std::array<StartPosture, 6> postures{};
  std::size_t count = 0;
  const bool is_low = head < kStandingHead * rig_->height;
  const std::span<const StartPosture> upright = std::span(kHighStarts).first(1),
                                      lowered = std::span(kLowStarts).subspan(1);
  for (const StartPosture& posture : is_low ? lowered : upright)
    for (const std::array<bool, 2>& raises : kRaisedHands) {
      postures[count] = posture;
      postures[count].wrists = kRaisedWrists;
      postures[count++].raises = raises;
    }
  tryPostures({postures.data(), count}, middle, pelvis, facing, fits);
}

/// Of a person whose hands may be at the floor. The head may be at either end, whichever way is expected.
void BodyTracker::tryBent(const Vector3d& middle, double top, double facing, Fits& fits) {
  constexpr int kBentRounds = 6;  // legs that bend, and arms before them, are found late
  std::array<RigPose, kBentStarts> starts;
  bentStarts(*rig_, seen_.points(), middle, top, facing, starts);
  for (const RigPose& start : starts) tryFrom(start, fits, kBentRounds);
}

/// `pelvis` (m): its height in a person who stands.
void BodyTracker::tryPostures(std::span<const StartPosture> postures, const Vector3d& middle, double pelvis,
                              double facing, Fits& fits) {
  for (const StartPosture& posture : postures) {
    for (const double yaw : {0.0, 0.7, -0.7}) {
      RigPose pose;
      pose.X_WP.translation() = middle;
      pose.X_WP.translation().z() = pelvis - posture.lower;
      pose.X_WP.linear() = Eigen::AngleAxisd(facing + yaw, Vector3d::UnitZ()).toRotationMatrix();
      if (posture.bends_legs) bendLegs(*rig_, posture.p_ankle, pose);
      if (posture.wrists > 0.0) raiseArms(*rig_, posture.wrists, pose, kRaisedAside, posture.raises);
      tryFrom(pose, fits);
    }
  }
}

void BodyTracker::tryFrom(const RigPose& start, Fits& fits, int rounds) {
  fitFrom(start, rounds);
  if (!mayFace(yawOf(body_.pose)) || isHeadlong(body_.X_WS)) return;
  const double cost = body_.misfit.cost * (floats() ? kFloats : 1.0);
  fits.all.add(cost, body_.X_WS);
  if (!(cost < fits.cost)) return;
  fits.cost = cost;
  fits.best = body_;
}

bool BodyTracker::mayFace(double yaw) const {
  return !expected_.yaw || std::cos(yaw - *expected_.yaw) >= 0.0;
}

/// Fits a person who lies.
void BodyTracker::tryLying(const Vector3d& middle, TrackedBody& best) {
  fit_.keepAboveFloor(true);
  LyingFits fits(*rig_);
  std::array<TrackedBody, 2> of_side;  // on the back, on the front
  std::array<LyingStart, kLyingStarts> starts;
  lyingStarts(*rig_, seen_.points(), middle, starts);
  for (const LyingStart& start : starts) {
    if (expected_.on_front.value_or(start.on_front) != start.on_front) continue;
    fitFrom(start.pose);
    fit_.gaps(body_.X_WS, body_.gap);
    if (fits.add(body_.misfit.cost, body_.X_WS, body_.gap, start.on_front))
      of_side[start.on_front ? 1 : 0] = body_;
  }
  best = of_side[fits.onFront() ? 1 : 0];
  lying_ = {true, fits.apart(), fits.frontOverBack()};
  if (fits.sidesAlike()) facing_known_ = false;
}

/// Sets pose and misfit of the body.
void BodyTracker::fitFrom(const RigPose& start, int rounds) {
  body_.pose = start;
  for (int round = 0; round < rounds; ++round) {
    fit_.refine(seen_, body_.pose, wide_, kStartWideSteps, body_.pose);
    searchLimbs({120, 0.3, 1.0}, {40, 0.2, 1.0});
  }
  fit_.refine(seen_, body_.pose, narrow_, kStartNarrowSteps, body_.pose);
  placeBody();
}

}  // namespace abstand::tracking
