// Initial search, tracking, loss.
#include "tracking/tracker/body_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "humanmodel/joint_covariance.hpp"
#include "tracking/tracker/head_peak.hpp"
#include "tracking/tracker/leg_posture.hpp"
#include "tracking/tracker/other_posture.hpp"
#include "tracking/tracker/raised_arms.hpp"
#include "tracking/tracker/seat_points.hpp"
#include "tracking/tracker/seen_segments.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

constexpr double kDamp = 0.7;         // share of the predicted motion that is used
constexpr double kUntwist = 0.2;      // 1/rad^2
constexpr double kHandRelaxes = 0.8;  // factor for each image; decays the wrist angle if nothing shows it
constexpr double kMaxGap = 0.25;      // s; no prediction over longer gaps
constexpr std::size_t kFewestPoints = 60;
constexpr double kLostBelow = 0.6, kFoundAbove = 0.7;  // explained share
constexpr int kBadImages = 5;
// m^2, of a followed body of somebody who may sit; bodies that fit cost 2e-4 to 4e-4. One that a search finds
// replaces it if it costs this many times as much, or less. Things in the hands of people who stand cost as
// much, and a search would put the arms there; legs whose feet are outside of the image, anywhere.
constexpr double kDoubtful = 5e-4, kBetterCost = 0.7;
// The same of anybody: bodies that fit cost up to 1e-3 at 5 m.
constexpr double kVeryDoubtful = 1.2e-3, kMuchBetterCost = 0.3;
// A search takes as long as to follow a body through ten images.
constexpr Backoff::Waits kSearchLost{10, 0.15, 1.0, 0.15};
constexpr Backoff::Waits kSearchDoubtful{0, 0.5, 2.0, 4.0};
constexpr int kWideSteps = 4, kNarrowSteps = 4;
// Of a limb's positions: times the smallest cost. None that costs more than LimbAlternatives::kAlike times
// the limb of the fitted body is an alternative.
constexpr double kKept = 2.0;
constexpr double kStands = 0.5;  // s; legs that were not seen for longer are those of a person who stands

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
// Share of the stature: lower heads do not belong to people who stand.
constexpr double kStandingHead = 0.85;
// Share of the stature: shoulders are at most 0.19 below the vertex of an upright head and hands reach 0.42
// below them (Drillis and Contini), so that those of a higher person are clear of the floor. Those of a
// person who stands hang higher than markStanding() looks.
constexpr double kHandsOffFloor = 0.70;
// m: people whose highest point is lower lie, perhaps with raised knees; seated on the floor, the head is at
// 0.8.
constexpr double kLyingTop = 0.65;

// m; a vertex nearer to the border of the image may be beyond it. The head of a person whose forehead is cut
// off was 0.10 to 0.18 too low.
constexpr double kAboveVertex = 0.20;

/// Whether the upper border of an image cuts off the person.
bool isCutAbove(std::span<const PersonImage> images) {
  return std::any_of(images.begin(), images.end(), [](const PersonImage& image) {
    const auto row = image.is_person.first(static_cast<std::size_t>(image.image->width));
    return std::find(row.begin(), row.end(), std::uint8_t{1}) != row.end();
  });
}

/// Whether a point (m, world) is within the image of any camera.
bool isInView(const BodyObservation& seen, const Vector3d& p_W) {
  return std::any_of(seen.views().begin(), seen.views().end(),
                     [&](const BodyView& view) { return view.pixelOf(view.X_CW() * p_W).has_value(); });
}

void bendLegs(const BodyRig& rig, const Vector3d& p_ankle, RigPose& pose) {
  RigPlacement X_WS;
  place(rig, pose, X_WS);
  for (const Limb& leg : {kLimbs[2], kLimbs[3]}) {
    const Vector3d hip = X_WS[0] * rig[leg.upper].p_parent;
    reachFor(rig, leg, X_WS, hip + X_WS[0].linear() * p_ankle, 0.0, pose);
  }
}

BodySolver::Vector priorsOf(const BodyRig& rig) {
  BodySolver::Vector w;
  const auto of = [&](RigSegment s, double v) { w.segment(rig[s].column, rig[s].freedoms).setConstant(v); };
  using enum RigSegment;
  of(kPelvis, 3.0);
  of(kChest, 8.0);
  of(kHead, 6.0);
  for (const RigSegment s : {kUpperArmLeft, kUpperArmRight, kForearmLeft, kForearmRight}) of(s, 0.5);
  for (const RigSegment s : {kHandLeft, kHandRight}) of(s, 2.0);
  for (const RigSegment s : {kThighLeft, kThighRight, kCalfLeft, kCalfRight}) of(s, 1.0);
  for (const RigSegment s : {kFootLeft, kFootRight}) of(s, 4.0);
  return w;
}

}  // namespace

BodyTracker::BodyTracker(const BodyRig& rig, std::uint64_t seed)
    : rig_{&rig},
      fit_{rig},
      limbs_{fit_},
      uncertainty_{rig},
      random_{seed},
      lost_{kSearchLost},
      doubtful_{kSearchDoubtful} {
  wide_.prior = priorsOf(rig);
  narrow_.prior = wide_.prior;
  wide_.reach = 0.20;
  narrow_.reach = 0.07;
}

const TrackedBody& BodyTracker::track(double t, std::span<const PersonImage> images) {
  const double dt = t - last_t_;
  last_t_ = t;
  if (dt > kTurns && body_.found) loseSight();
  seen_.update(images);
  was_replaced_ = false;
  const double highest = headHeight(), top = highest / rig_->height;
  if (!(highest < kLyingTop)) lying_ = {};
  fit_.keepAboveFloor(lying_.lies);
  is_cut_ = isCutAbove(images);
  const bool may_sit = top > kHandsOffFloor && top < kStandingHead;
  fit_.keepLegsApart(may_sit);
  if (may_sit && !(body_.found && kneels(body_.X_WS))) {
    seen_.markStanding();
    if (body_.found) seen_.setSeatAside(*rig_, body_.X_WS);
  }
  if (seen_.points().count < kFewestPoints) {
    body_.found = false;
    lost_.reset();
  } else if (body_.found) {
    follow(dt);
    badly_ = body_.misfit.explained < kLostBelow ? badly_ + 1 : 0;
    if (badly_ >= kBadImages) body_.found = false;
    const bool is_doubtful = may_sit && body_.misfit.cost > kDoubtful && !areFeetCut();
    if (body_.found && (is_doubtful || body_.misfit.cost > kVeryDoubtful)) searchAgain(t);
  }
  const bool is_lost = !body_.found && seen_.points().count >= kFewestPoints;
  is_searched_ = is_lost && lost_.isDue(t);
  if (is_searched_) {
    find();
    if (may_sit && body_.found && kneels(body_.X_WS)) {
      seen_.unmarkStanding();
      find();
    } else if (may_sit && body_.found && seen_.setSeatAside(*rig_, body_.X_WS)) {
      find();
    }
    appeared_t_ = t;
    lost_.note(t, body_.found);
  } else if (is_lost) {
    body_.misfit = {};
  }
  finish(t);
  return body_;
}

/// m, z of the vertex: that of the highest point, unless a hand is above the head.
double BodyTracker::headHeight() const {
  const double top = seen_.points().top();
  if (!body_.found) return headBelowHands(seen_).value_or(top);
  humanmodel::SkeletonFrame last;  // body_.frame is empty after resume()
  jointsOf(*rig_, body_.X_WS, humanmodel::JointState::kTracked, last);
  return raisesHands(last) ? std::min(top, last[humanmodel::Joint::kHeadTop].z()) : top;
}

/// Of a person of whom there was no image for longer than kTurns: may be elsewhere, and have turned around. A
/// search starts in the last direction.
void BodyTracker::loseSight() {
  body_.found = facing_known_ = false;
  lost_.reset();
}

const TrackedBody& BodyTracker::search(const BodyTracker& other, double yaw) {
  seen_ = other.seen_;
  is_cut_ = other.is_cut_;
  front_ = yaw;
  find();
  return body_;
}

void BodyTracker::resume(const RigPose& pose, const Lying& lying, double since) {
  appeared_t_ = since;
  lying_ = lying;
  body_.pose = pose;
  place(*rig_, pose, body_.X_WS);
  body_.found = true;
  velocity_.setZero();
  badly_ = 0;
  front_ = yawOf(pose);
}

void BodyTracker::widenHands(const std::array<double, 2>& extent) {
  using enum humanmodel::Joint;
  body_.held = extent;
  humanmodel::addRadius(body_.frame, kHandLeft, extent[0]);
  humanmodel::addRadius(body_.frame, kHandRight, extent[1]);
}

void BodyTracker::encloseOther(const humanmodel::SkeletonFrame& other) {
  humanmodel::SkeletonFrame& frame = body_.frame;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    const Matrix3d either = humanmodel::enclosingCovariance(humanmodel::covarianceOf(frame, joint),
                                                            humanmodel::covarianceOf(other, joint));
    humanmodel::setCovariance(frame, joint, humanmodel::sumWithOffset(either, other.p[j] - frame.p[j]));
  }
}

void BodyTracker::searchLimbs(const LimbSearch::Scope& arms, const LimbSearch::Scope& legs) {
  bool found = false;
  RigPose other = body_.pose;
  for (std::size_t k = 0; k < kLimbs.size(); ++k)
    found |= limbs_.search(seen_, k, kLimbs[k].isArm() ? arms : legs, random_, other);
  if (!found) return;
  fit_.refine(seen_, other, narrow_, kNarrowSteps, other);
  RigPlacement X_WS;
  place(*rig_, body_.pose, X_WS);
  const double before = fit_.misfit(seen_, X_WS).cost;
  place(*rig_, other, X_WS);
  if (fit_.misfit(seen_, X_WS).cost < before) body_.pose = other;
}

/// Feet of a person of whose lower legs nothing has been seen for a while, as behind a bench. For shorter,
/// legs hide each other, in the air, too.
void BodyTracker::plantHiddenFeet() {
  std::uint32_t feet = 0;
  for (const Limb& leg : {kLimbs[2], kLimbs[3]}) {
    if (body_.visible[index(leg.lower)] >= kSeenShare || body_.visible[index(leg.end)] >= kSeenShare)
      legs_seen_t_ = last_t_;
    feet |= DepthFit::bit(leg.end);
  }
  wide_.planted = narrow_.planted = last_t_ - legs_seen_t_ > kStands ? feet : 0;
}

void BodyTracker::follow(double dt) {
  const RigPose last = body_.pose;
  RigPose expected = last;
  const bool continues = dt > 0.0 && dt < kMaxGap;
  if (continues) advance(*rig_, kDamp * dt * velocity_, expected);
  for (const RigSegment hand : {RigSegment::kHandLeft, RigSegment::kHandRight})
    for (double& angle : expected.angle[index(hand)]) angle *= kHandRelaxes;
  plantHiddenFeet();
  wide_.untwist = narrow_.untwist = kUntwist;
  body_.pose = expected;
  fit_.refine(seen_, expected, wide_, kWideSteps, body_.pose);
  fit_.refine(seen_, expected, narrow_, kNarrowSteps, body_.pose);
  searchLimbs({100, 0.2, kKept}, {30, 0.12, kKept});
  velocity_ =
      continues ? BodySolver::Vector(difference(*rig_, last, body_.pose) / dt) : BodySolver::Vector::Zero();
  placeBody();
  uncrossArms();
  lowerLeg();
  lowerArms();
}

/// Somebody who sits down, and whose legs were lost in the chair before, is found again on the chair;
/// likewise somebody of whom a body is followed that explains hardly anything, as after bending to the floor
/// close to a camera.
void BodyTracker::searchAgain(double t) {
  if (!doubtful_.isDue(t)) return;
  const TrackedBody followed = body_;
  const BodySolver::Vector velocity = velocity_;
  const std::mt19937_64 random = random_;
  const int badly = badly_;
  find();
  const double limit = sitsOnSeat(*rig_, body_.X_WS) ? kBetterCost : kMuchBetterCost;
  was_replaced_ = body_.found && body_.misfit.cost < limit * followed.misfit.cost;
  doubtful_.note(t, was_replaced_);
  if (was_replaced_) return;
  body_ = followed;
  random_ = random;
  velocity_ = velocity;
  badly_ = badly;
}

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
  TrackedBody best;
  if (top < kLyingTop) {
    tryLying(middle, best);
  } else if (front_) {
    tryStarts(middle, top, *front_, best);
  } else {
    for (std::size_t v = 0; v < seen_.views().size(); ++v)
      if (count[v] > 0.0) tryStarts(middle, top, towards[v] + (expected_.away ? kPi : 0.0), best);
    if (expected_.yaw) tryStarts(middle, top, *expected_.yaw, best);
  }
  body_ = best;
  if (std::isfinite(body_.misfit.cost)) uncrossLegs(), uncrossArms(), lowerLeg(), lowerArms();
  body_.found = body_.misfit.explained > kFoundAbove;
  velocity_.setZero();
  badly_ = 0;
  limbs_.forgetTries();
}

/// Fits the postures of a start that faces `facing` (rad), about the middle of the body, its highest point at
/// z = `top` (m); keeps the best of these and of `best`.
void BodyTracker::tryStarts(const Vector3d& middle, double top, double facing, TrackedBody& best) {
  const double above = vertexAbovePelvis(*rig_);
  const bool is_low = top < kStandingHead * rig_->height;
  const std::span<const StartPosture> postures =
      is_low ? std::span<const StartPosture>(kLowStarts) : std::span<const StartPosture>(kHighStarts);
  tryPostures(postures, middle, top - above, facing, best);
  if (top > rig_->height + kHandsHighest)
    tryPostures(kRaisedStarts, middle, rig_->height - above, facing, best);
  if (const std::optional<double> head = headBelowHands(seen_)) tryRaised(middle, *head, facing, best);
  if (!is_cut_) return;
  tryPostures(kCutStarts, middle, top - above, facing, best);
  if (top < rig_->height) tryPostures(kOnFloorStarts, middle, rig_->height - above, facing, best);
}

/// Of a person whose vertex is at z = `head` (m), below the hands.
void BodyTracker::tryRaised(const Vector3d& middle, double head, double facing, TrackedBody& best) {
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
  tryPostures({postures.data(), count}, middle, pelvis, facing, best);
}

/// `pelvis` (m): its height in a person who stands.
void BodyTracker::tryPostures(std::span<const StartPosture> postures, const Vector3d& middle, double pelvis,
                              double facing, TrackedBody& best) {
  for (const StartPosture& posture : postures) {
    for (const double yaw : {0.0, 0.7, -0.7}) {
      RigPose pose;
      pose.X_WP.translation() = middle;
      pose.X_WP.translation().z() = pelvis - posture.lower;
      pose.X_WP.linear() = Eigen::AngleAxisd(facing + yaw, Vector3d::UnitZ()).toRotationMatrix();
      if (posture.bends_legs) bendLegs(*rig_, posture.p_ankle, pose);
      if (posture.wrists > 0.0) raiseArms(*rig_, posture.wrists, pose, kRaisedAside, posture.raises);
      fitFrom(pose);
      if (mayFace(yawOf(body_.pose)) && body_.misfit.cost < best.misfit.cost) best = body_;
    }
  }
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
void BodyTracker::fitFrom(const RigPose& start) {
  body_.pose = start;
  for (int round = 0; round < 3; ++round) {
    fit_.refine(seen_, body_.pose, wide_, kStartWideSteps, body_.pose);
    searchLimbs({120, 0.3, 1.0}, {40, 0.2, 1.0});
  }
  fit_.refine(seen_, body_.pose, narrow_, kStartNarrowSteps, body_.pose);
  placeBody();
}

/// Of its pose.
void BodyTracker::placeBody() {
  place(*rig_, body_.pose, body_.X_WS);
  body_.misfit = fit_.misfit(seen_, body_.X_WS);
}

/// Whether the border cuts off the person at the head: what is seen of it does not show where it ends.
bool BodyTracker::isHeadCut() const {
  if (!is_cut_) return false;
  const Vector3d above =
      jointPosition(*rig_, body_.X_WS, humanmodel::Joint::kHeadTop) + kAboveVertex * Vector3d::UnitZ();
  return !isInView(seen_, above);
}

/// Whether the feet are outside of the images of all cameras: what is seen does not show where the legs end.
bool BodyTracker::areFeetCut() const {
  using enum humanmodel::Joint;
  return !isInView(seen_, jointPosition(*rig_, body_.X_WS, kAnkleLeft)) &&
         !isInView(seen_, jointPosition(*rig_, body_.X_WS, kAnkleRight));
}

void BodyTracker::finish(double t) {
  uncertainty_.reuse(body_.frame);
  body_.frame = humanmodel::SkeletonFrame{};
  body_.frame.t = t;
  body_.visible.fill(0.0);
  body_.held.fill(0.0);
  if (!body_.found) {
    uncertainty_.forget();
    if (t - found_t_ > kTurns) {
      front_.reset();
      facing_known_ = false;
    }
    return;
  }
  found_t_ = t;
  expected_ = {};
  if (!facesUpOrDown(body_.pose.X_WP.linear().col(0))) front_ = yawOf(body_.pose);
  fit_.visibility(seen_, body_.X_WS, body_.visible);
  if (isHeadCut()) body_.visible[index(RigSegment::kHead)] = 0.0;
  fit_.support(seen_, body_.X_WS, body_.support);
  fit_.gaps(body_.X_WS, body_.gap);
  jointsOf(*rig_, body_.X_WS, humanmodel::JointState::kTracked, body_.frame);
  const PersonDoubts doubts{t - appeared_t_, stature_deviation_, areFeetCut(), facing_known_, lying_};
  uncertainty_.state({t, seen_, fit_, limbs_}, doubts, body_);
}

}  // namespace abstand::tracking
