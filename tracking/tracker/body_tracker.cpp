// Tracking, loss.
#include "tracking/tracker/body_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "humanmodel/joint_covariance.hpp"
#include "tracking/tracker/head_peak.hpp"
#include "tracking/tracker/leg_posture.hpp"
#include "tracking/tracker/other_posture.hpp"
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
constexpr double kLostBelow = 0.6;  // explained share
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
// m; a Kinect's depths of a surface scatter by 2 cm there, in steps of 3.6 cm.
constexpr double kFarAway = 3.5;
constexpr double kWorse = 1.1;  // times the cost of the last pose; feet that are planted cost something
// Of a limb's positions: times the smallest cost. None that costs more than LimbAlternatives::kAlike times
// the limb of the fitted body is an alternative.
constexpr double kKept = 2.0;
constexpr double kStands = 0.5;  // s; legs that were not seen for longer are those of a person who stands

// m; a vertex nearer to the border of the image may be beyond it. The head of a person whose forehead is cut
// off was 0.10 to 0.18 too low.
constexpr double kAboveVertex = 0.20;

constexpr double kSole = 0.05;  // m, below ankles and toes at most

bool hasPerson(std::span<const std::uint8_t> row) {
  return std::find(row.begin(), row.end(), std::uint8_t{1}) != row.end();
}

/// Whether the upper border of an image cuts off the person.
bool isCutAbove(std::span<const PersonImage> images) {
  return std::any_of(images.begin(), images.end(), [](const PersonImage& image) {
    return hasPerson(image.is_person.first(static_cast<std::size_t>(image.image->width)));
  });
}

/// Whether the lower border of each image does that shows the person.
bool isCutBelow(std::span<const PersonImage> images) {
  return std::all_of(images.begin(), images.end(), [](const PersonImage& image) {
    return hasPerson(image.is_person.last(static_cast<std::size_t>(image.image->width))) ||
           !hasPerson(image.is_person);
  });
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
  if (!(highest < (lying_.lies ? kLyingTop : kHandsOffFloor * rig_->height))) lying_ = {};
  fit_.keepAboveFloor(lying_.lies);
  is_cut_ = {isCutAbove(images), isCutBelow(images)};
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
    badly_ = body_.misfit.explained < kLostBelow || isHeadlong(body_.X_WS) ? badly_ + 1 : 0;
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

void BodyTracker::searchLimbs(const LimbSearch::Scope& arms, const LimbSearch::Scope& legs) {
  bool found = false;
  RigPose other = body_.pose;
  for (std::size_t k = 0; k < kLimbs.size(); ++k)
    found |= limbs_.search(seen_, k, kLimbs[k].isArm() ? arms : legs, random_, other);
  if (!found) return;
  fit_.refine(seen_, other, narrow_, kNarrowSteps, other);
  if (costOf(other) < costOf(body_.pose)) body_.pose = other;
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
  returnTo(last);
  searchLimbs({100, 0.2, kKept}, {30, 0.12, kKept});
  velocity_ =
      continues ? BodySolver::Vector(difference(*rig_, last, body_.pose) / dt) : BodySolver::Vector::Zero();
  placeBody();
  standLegs();
  uncrossArms();
  lowerLeg();
  plantLegs();
  lowerArms();
}

/// The steps of a fit do not compare its cost, and the noise of somebody far away, or limbs that the image
/// cuts off, lead some of them astray. A pose that explains the image worse than the last one does is then
/// refined from that, in small steps. Not so of others, who have things in their hands that arms would
/// explain better.
void BodyTracker::returnTo(const RigPose& last) {
  if (!is_cut_.above && !is_cut_.below && meanDistance() < kFarAway) return;
  const double limit = costOf(body_.pose) / kWorse;
  if (!(costOf(last) < limit)) return;
  RigPose near = last;
  fit_.refine(seen_, last, narrow_, kNarrowSteps, near);
  if (costOf(near) < limit) body_.pose = near;
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
  const Lying lying = lying_;
  find();
  const double limit = sitsOnSeat(*rig_, body_.X_WS) ? kBetterCost : kMuchBetterCost;
  was_replaced_ = body_.found && body_.misfit.cost < limit * followed.misfit.cost;
  doubtful_.note(t, was_replaced_);
  if (was_replaced_) return;
  body_ = followed;
  lying_ = lying;
  random_ = random;
  velocity_ = velocity;
  badly_ = badly;
}

/// m, of the points from the cameras that see them.
double BodyTracker::meanDistance() const {
  const SeenPoints& points = seen_.points();
  double sum = 0.0;
  for (std::size_t i = 0; i < points.count; ++i) sum += (points.point(i) - seen_.eyeOf(i)).norm();
  return sum / static_cast<double>(points.count);
}

/// m^2, of a pose in the last image.
double BodyTracker::costOf(const RigPose& pose) {
  RigPlacement X_WS;
  place(*rig_, pose, X_WS);
  return fit_.misfit(seen_, X_WS).cost;
}

/// Of its pose.
void BodyTracker::placeBody() {
  place(*rig_, body_.pose, body_.X_WS);
  body_.misfit = fit_.misfit(seen_, body_.X_WS);
}

/// Whether a point (m, world) is within the image of any camera.
bool BodyTracker::isInView(const Vector3d& p_W) const {
  return std::any_of(seen_.views().begin(), seen_.views().end(),
                     [&](const BodyView& view) { return view.pixelOf(view.X_CW() * p_W).has_value(); });
}

/// Whether the border cuts off the person at the head: what is seen of it does not show where it ends.
bool BodyTracker::isHeadCut() const {
  if (!is_cut_.above) return false;
  const Vector3d above =
      jointPosition(*rig_, body_.X_WS, humanmodel::Joint::kHeadTop) + kAboveVertex * Vector3d::UnitZ();
  return !isInView(above);
}

/// Whether the feet are outside of the images of all cameras: what is seen does not show where the legs end.
bool BodyTracker::areFeetCut() const {
  using enum humanmodel::Joint;
  return !isInView(jointPosition(*rig_, body_.X_WS, kAnkleLeft)) &&
         !isInView(jointPosition(*rig_, body_.X_WS, kAnkleRight));
}

/// Whether an image reaches to the toes and the sole of a foot.
bool BodyTracker::showsFoot() const {
  using enum humanmodel::Joint;
  const auto is_whole = [this](humanmodel::Joint ankle, humanmodel::Joint toe) {
    const Vector3d heel = jointPosition(*rig_, body_.X_WS, ankle),
                   tip = jointPosition(*rig_, body_.X_WS, toe);
    return isInView(heel - kSole * Vector3d::UnitZ()) && isInView(tip - kSole * Vector3d::UnitZ());
  };
  return is_whole(kAnkleLeft, kToeLeft) || is_whole(kAnkleRight, kToeRight);
}

bool BodyTracker::isBent() const {
  const Vector3d trunk = jointPosition(*rig_, body_.X_WS, humanmodel::Joint::kNeck) -
                         jointPosition(*rig_, body_.X_WS, humanmodel::Joint::kPelvis);
  return trunk.z() < std::sqrt(0.5) * trunk.norm();
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
