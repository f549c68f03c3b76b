// Measure, fit, follow.
#include "tracking/tracker/tracked_person.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "tracking/tracker/other_posture.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kMeasured = 15;  // images
// Times that of the upright body, below which the person sits, or raises the arms. Of simulated people with
// raised arms, the right stature cost at most 0.72 times as much as the wrong one; of others, the wrong one
// at least 0.95, and 0.8 with a hand at the head.
constexpr double kOtherCost = 0.8;
// Likewise of who stoops: measured 0.49 to 0.54; of boxers, who stand with bent legs, 0.79.
constexpr double kLoweredCost = 0.65;
// m^2: the bodies of people who stand cost less, without things that touch them.
constexpr double kDoubtfulCost = 5e-4;
// Times the cost of a body found without these things, below which the followed one goes on.
constexpr double kFollowedCost = 1.3;
constexpr Backoff::Waits kSeparations{1, 0.5, 2.0, 4.0};
constexpr double kOtherStature = 0.1;  // m; the evidence of a body that is so wrong does not count
constexpr double kHigher = 0.06;       // m, above the measured stature: hair, and the noise of a Kinect
constexpr double kSteady = 0.04;       // m, largest difference of the heights of images that are measured

/// The mean body of a stature (m).
humanmodel::HumanOptions usualBody(double height) {
  humanmodel::HumanOptions body;
  body.height = height;
  return body;
}

/// A body that was on this path at `t` (s) starts on it, or is searched for.
void expect(const BodyPath& path, double t, bool starts_on_path, BodyTracker& tracker) {
  const BodyPath::Point* point = path.nearest(t);
  if (!point) return;
  if (starts_on_path)
    tracker.resume(point->pose, {}, t);
  else
    tracker.expectFacing(yawOf(point->pose));
}

/// `now` and, if there is one, `other`, which faces the other way. Returns the body of `now`.
const TrackedBody& trackBoth(double t, std::span<const PersonImage> images, BodyFollower& now,
                             BodyFollower& other) {
  if (other) now.tracker->setFacingKnown(other.track(t, images).found && !now.tracker->lying().lies);
  return now.track(t, images);
}

/// Both facing directions count while the images do not decide.
void encloseOther(BodyFollower& now, const BodyFollower& other) {
  const TrackedBody &mine = now.tracker->body(), &its = other.tracker->body();
  if (mine.found) now.tracker->encloseOther(its.found ? its.frame : flippedFacing(mine.frame));
}

}  // namespace

TrackedPerson::TrackedPerson(const Options& options) : options_{options}, separations_{kSeparations} {
  facing_.away = options.away.value_or(false);
  facing_.given = options.away.has_value();
  if (!options.height) return;
  stature_ = Stature::given(*options.height);
  now_ = followerOf(usualBody(stature_.used), stature_, facing_.away);
  fitted_ = !options.fit_body;
}

TrackedPerson::TrackedPerson(const Options& options, std::shared_ptr<const KnownBody> known)
    : options_{options},
      facing_{known->facing},
      stature_{known->stature},
      now_{followerOf(known->assumed.body, stature_, facing_.away)},
      things_{known->things},
      separations_{kSeparations},
      known_{std::move(known)},
      started_{true},
      fitted_{true},
      compared_{true},
      decides_{false} {
  now_.held = HeldThings(known_->assumed.held);
  if (!known_->other) return;
  other_ = followerOf(known_->other->body, stature_, !facing_.away);
  other_.held = HeldThings(known_->other->held);
}

KnownBody TrackedPerson::known() const {
  const auto side = [](const BodyFollower& of) {
    return KnownBody::Side{of.body, of.path, of.held.atStart()};
  };
  KnownBody known{side(now_), std::nullopt, stature_, facing_, things_};
  if (facing_.decided()) known.things.keepChair();
  if (other_) known.other = side(other_);
  return known;
}

BodyFollower TrackedPerson::followerOf(const humanmodel::HumanOptions& body, const Stature& stature,
                                       bool away) const {
  Facing facing = facing_;
  facing.away = away;
  return {body, stature, facing, options_.seed};
}

/// Another body that goes on where `last` is.
BodyFollower TrackedPerson::continued(const BodyFollower& last, const humanmodel::HumanOptions& body,
                                      bool away) const {
  BodyFollower next = followerOf(body, stature_, away);
  next.continueFrom(last);
  return next;
}

const TrackedBody* TrackedPerson::see(double t, std::span<const PersonImage> all) {
  touching_.see(all);
  if (!started_ && !start(t, all)) {
    keepMeasured(t, all);
    return nullptr;
  }
  std::span<const PersonImage> images = things_.remove(all);
  if (other_ && t - found_t_ > BodyTracker::kTurns) endComparison();
  follow(t, images);
  if (separateThings(t, images)) {
    images = things_.remove(all);
    track(t, images);
  }
  if (now_.tracker->body().found) found_t_ = t;
  tryOtherFacing();
  compareFacings(t, images);
  const TrackedBody& body = renewBody(t, images) ? track(t, images) : now_.tracker->body();
  if (body.found) noteFirst(t);  // after the likelier direction was assumed
  if (now_.tracker->wasReplaced()) things_.forget();
  if (body.found) things_.learn(now_.tracker->seen(), now_.tracker->fit(), body.X_WS);
  now_.learn();
  if (other_) {
    other_.learn();
    encloseOther(now_, other_);
  }
  compareMeasured(t);  // last, as `images` are valid until the next things_.remove()
  return &body;
}

void TrackedPerson::noteFirst(double t) {
  if (first_) return;
  first_ = {t, now_.tracker->lying(), now_.tracker->body().pose, std::nullopt};
  if (other_ && other_.tracker->body().found) first_->other = other_.tracker->body().pose;
}

void TrackedPerson::startBefore() {
  const auto startAt = [&](const humanmodel::HumanOptions& body, bool away, const RigPose& pose) {
    BodyFollower before = followerOf(body, stature_, away);
    before.tracker->resume(pose, first_->lying, -first_->t);
    return before;
  };
  before_ = startAt(now_.body, facing_.away, first_->now);
  if (other_ && first_->other) other_before_ = startAt(other_.body, !facing_.away, *first_->other);
}

TrackedBody TrackedPerson::seeBefore(double t, std::span<const PersonImage> all) {
  if (!before_) startBefore();
  trackBoth(-t, things_.remove(all), before_, other_before_);
  before_.tracker->widenHands(now_.held.extent());
  if (other_before_) {
    other_before_.tracker->widenHands(other_.held.extent());
    encloseOther(before_, other_before_);
  }
  TrackedBody body = before_.tracker->body();
  body.frame.t = t;
  return body;
}

/// Measures the person. Returns whether a body can be tracked now.
bool TrackedPerson::start(double t, std::span<const PersonImage> images) {
  coming_.see(t, images);
  if (!now_) measure(images);
  started_ = !coming_.isGrowing() && (now_ || extents_.size() == kMeasured);
  return started_;
}

/// Those in which a person who comes into view is not whole show no body.
void TrackedPerson::keepMeasured(double t, std::span<const PersonImage> images) {
  if (coming_.isGrowing()) measured_.clear();
  if (coming_.isGrowing() || !options_.compares_measured) return;
  if (measured_.size() == kMeasured) measured_.erase(measured_.begin());
  KeptMoment& moment = measured_.emplace_back();
  moment.t = t;
  for (const PersonImage& image : images) moment.add(image, t);
}

/// Tracks the body that faces as assumed.
void TrackedPerson::follow(double t, std::span<const PersonImage> images) {
  if (!now_) {
    makeMeasured();
    if (checkUpright(t, images)) return;
  }
  track(t, images);
}

/// Until a body is found, every second search is for one that faces the other way: the back of a chair may
/// hide most of a person, and not be explained by one who faces the camera.
void TrackedPerson::tryOtherFacing() {
  if (first_ || known_ || compared_ || facing_.given || !now_.tracker->searchedInVain()) return;
  facing_.away = !facing_.away;
  now_.tracker->expectAway(facing_.away);
}

/// Things that touch the legs of somebody who stands, and is not found, or badly, for them. Returns whether
/// there are any; the bodies are then where they explain the images without them.
bool TrackedPerson::separateThings(double t, std::span<const PersonImage> images) {
  const TrackedBody& body = now_.tracker->body();
  if ((body.found && body.misfit.cost < kDoubtfulCost) || !separations_.isDue(t)) return false;
  BodyFollower trial = followerOf(now_.body, stature_, facing_.away);
  if (body.found)
    trial.tracker->expectFacing(yawOf(body.pose));
  else if (known_)
    expect(known_->assumed.path, t, false, *trial.tracker);
  const bool is_separated = touching_.search(t, images, body.found ? body.misfit.cost : kInfinity, trial);
  if (touching_.searched()) separations_.note(t, is_separated);
  if (!is_separated) return false;
  things_.forget();
  things_.keep(images, touching_.rest());
  if (!fitting_.valid()) calibration_ = {};
  trial_ = {};
  const TrackedBody& found = trial.tracker->body();
  // Seen from the side, a search may find the mirror image of a followed body of which only a leg is wrong.
  if (body.found && now_.track(t, touching_.rest()).misfit.cost < kFollowedCost * found.misfit.cost)
    return true;
  now_.tracker->resume(found.pose, {}, t);
  if (!other_) return true;
  other_ = followerOf(other_.body, stature_, !facing_.away);
  other_.startTurned(trial);
  return true;
}

/// All bodies; returns the one that faces as assumed.
const TrackedBody& TrackedPerson::track(double t, std::span<const PersonImage> images) {
  if (known_) {
    expect(known_->assumed.path, t, options_.starts_on_path, *now_.tracker);
    if (known_->other) expect(known_->other->path, t, options_.starts_on_path, *other_.tracker);
  }
  const TrackedBody& body = trackBoth(t, images, now_, other_);
  if (body.found) known_.reset();
  return body;
}

/// Keeps the last images that show the person's height.
void TrackedPerson::measure(std::span<const PersonImage> images) {
  const VerticalExtent extent = verticalExtent(images);
  if (extent.height <= 0.0) return;
  if (extents_.size() == kMeasured) extents_.erase(extents_.begin());
  extents_.push_back(extent);
}

void TrackedPerson::makeMeasured() {
  stature_ = measureStature(extents_);
  now_ = followerOf(usualBody(stature_.used), stature_, facing_.away);
  fitted_ = !options_.fit_body;
}

/// Somebody tall who sits, kneels or stoops is as high as somebody short who stands; somebody short with
/// raised arms, as somebody tall; a child who stands, as an adult who sits. If the first image is explained
/// better so, the stature is that, and its interval includes those of all postures that explain it so well.
/// Returns whether the image was tracked for it.
bool TrackedPerson::checkUpright(double t, std::span<const PersonImage> images) {
  if (stature_.source == Stature::Source::kGiven || !std::isfinite(stature_.seen)) return false;
  const DepthMisfit assumed = now_.track(t, images).misfit;
  const double limit = kOtherCost * assumed.cost;
  double best = limit;
  std::array<double, 2> interval{kInfinity, -kInfinity};
  for (const OtherPosture& other : otherPostures(stature_)) {
    BodyFollower trial = followerOf(usualBody(other.stature.used), other.stature, facing_.away);
    trial.tracker->allowChair(false);  // the upright body explains all points, too
    const TrackedBody& found = trial.track(t, images);
    trial.tracker->allowChair(true);
    const double own_limit = other.kind == OtherPosture::Kind::kLowered ? kLoweredCost * assumed.cost : limit;
    if (!found.found || found.misfit.cost >= own_limit || !isIn(other.kind, found.frame, *trial.rig))
      continue;
    interval = {std::min(interval[0], other.stature.interval[0]),
                std::max(interval[1], other.stature.interval[1])};
    if (found.misfit.cost >= best) continue;
    best = found.misfit.cost;
    stature_ = other.stature;
    now_ = std::move(trial);
  }
  if (!stature_.known() && best < limit) stature_.interval = interval;
  return true;
}

/// Who lies has sides of another kind: decideLying().
bool TrackedPerson::mayCompare() const {
  return options_.fit_body && !compared_ && !facing_.decided() && !facing_.lies &&
         now_.tracker->body().found && !now_.tracker->lying().lies;
}

/// Starts to track the body that faces the other way, and assumes the likelier direction.
void TrackedPerson::compareFacings(double t, std::span<const PersonImage> images) {
  if (mayCompare()) {
    compared_ = true;
    other_ = followerOf(now_.body, stature_, !facing_.away);
    other_.startTurned(now_);
    other_.track(t, images);
  }
  if (!other_ || !decides_) return;
  const TrackedBody &mine = now_.tracker->body(), &its = other_.tracker->body();
  const bool is_fitted = std::isfinite(mine.misfit.cost) && std::isfinite(its.misfit.cost);
  if (is_fitted && (mine.found || its.found)) {
    addToTrial(t, now_, other_);
    trial_.judge(facing_);
    assume(trial_.isLikelyAway(facing_.away));
  }
  if (facing_.decided()) endComparison();
}

/// Bodies that face as assumed, and the other way, in one image. Evidence with wrong poses does not count.
void TrackedPerson::addToTrial(double t, const BodyFollower& mine, const BodyFollower& its) {
  if (mine.tracker->wasReplaced() || its.tracker->wasReplaced()) trial_ = {};
  BySide<FacingEvidence> evidence;
  evidence[facing_.away] = facingEvidence(*mine.tracker);
  evidence[!facing_.away] = facingEvidence(*its.tracker);
  trial_.add(t, evidence[false], evidence[true]);
}

/// In the images before the first one of both bodies, if that is `t`.
void TrackedPerson::compareMeasured(double t) {
  const std::vector<KeptMoment> measured = std::exchange(measured_, {});
  if (!first_ || first_->t != t || !decides_ || !other_ || !other_.tracker->body().found) return;
  for (auto moment = measured.rbegin(); moment != measured.rend(); ++moment) {
    seeBefore(moment->t, moment->views());
    const TrackedBody &mine = before_.tracker->body(), &its = other_before_.tracker->body();
    if (!mine.found || !its.found) break;
    addToTrial(moment->t, before_, other_before_);
  }
  before_ = {};
  other_before_ = {};
}

void TrackedPerson::decideFacing(double ratio) {
  facing_.ratio = ratio;
  now_.tracker->setFacingKnown(facing_.decided());
}

void TrackedPerson::assume(bool away) {
  if (away == facing_.away) return;
  facing_.away = away;
  things_.forgetChair();
  std::swap(now_, other_);
}

void TrackedPerson::endComparison() {
  other_ = {};
  calibration_[!facing_.away] = {};
  now_.tracker->setFacingKnown(facing_.decided());
}

/// Measures again, or fits. Returns whether there is a new body, which has tracked nothing yet.
bool TrackedPerson::renewBody(double t, std::span<const PersonImage> images) {
  const bool is_given = stature_.source == Stature::Source::kGiven;
  if (!is_given && !fitting_.valid() && remeasure(images)) return true;
  if (fitted_) return false;
  if (!fitting_.valid()) {
    BodyCalibration& assumed = calibration_[facing_.away];
    assumed.add(t, *now_.tracker);
    if (other_) calibration_[!facing_.away].add(t, *other_.tracker);
    if (!assumed.complete()) return false;
    if (options_.fit_aside)
      fitting_ = std::async(std::launch::async, fit, std::move(calibration_), startOfFit());
  }
  if (fitting_.valid() && fitting_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return false;
  adopt(fitting_.valid() ? fitting_.get() : fit(std::move(calibration_), startOfFit()));
  return true;
}

/// Whether the last image may show another stature: that of somebody who stands upright, if it is unknown,
/// or who is higher than the measured one.
bool TrackedPerson::mayRemeasure() const {
  const TrackedBody& body = now_.tracker->body();
  if (!body.found || raisesHands(body.frame)) return false;
  if (!stature_.known()) return standsUpright(body.frame, *now_.rig);
  return now_.tracker->seen().points().top() > stature_.used + kHigher;
}

bool TrackedPerson::remeasure(std::span<const PersonImage> images) {
  if (!mayRemeasure()) {
    extents_.clear();
    return false;
  }
  extents_.push_back(verticalExtent(images));
  if (extents_.size() < kMeasured) return false;
  const auto [low, high] = std::minmax_element(
      extents_.begin(), extents_.end(),
      [](const VerticalExtent& a, const VerticalExtent& b) { return a.height < b.height; });
  const Stature measured = measureStature(extents_);
  const bool is_steady = high->height - low->height < kSteady;
  extents_.erase(extents_.begin());
  if (!measured.known() || !is_steady) return false;
  if (stature_.known() && measured.used < stature_.used + kHigher) return false;
  // As high as in the posture that did not show the stature.
  if (!stature_.known() && std::abs(measured.used - stature_.seen) < kHigher) return false;
  extents_.clear();
  stature_ = measured;
  // Lengths that were fitted belong to the other stature.
  const humanmodel::HumanOptions usual = usualBody(stature_.used);
  now_ = continued(now_, usual, facing_.away);
  if (other_) other_ = continued(other_, usual, !facing_.away);
  calibration_ = {};
  fitted_ = !options_.fit_body;
  return true;
}

void TrackedPerson::settle() {
  if (!now_) {
    if (extents_.empty()) return;
    makeMeasured();
  }
  if (!fitted_) adopt(fitting_.valid() ? fitting_.get() : fit(std::move(calibration_), startOfFit()));
}

TrackedPerson::Fit TrackedPerson::startOfFit() const {
  return {{now_.body, now_.body}, facing_, stature_, now_.tracker->lying().front_over_back, compared_, false};
}

void TrackedPerson::decideLying(BodyCalibration& images, bool on_front, Fit& fit) {
  const humanmodel::HumanOptions& body = fit.body[on_front];
  const double turned = images.whenTurned(body);
  fit.facing.decideLying(on_front ? 1.0 / turned : turned, fit.front_over_back);
  fit.turned = fit.facing.away != on_front;
  if (fit.turned) images.flipFacing(body);
}

/// Narrows the interval. A smaller stature that explains the images clearly better than the assumed one
/// replaces it: that of a child. A larger one may explain things that are close to the person.
void TrackedPerson::decideStature(BySide<BodyCalibration>& images, Fit& fit) {
  const auto plausible = images[fit.facing.away].plausibleStatures(fit.body[0], fit.stature.interval);
  if (!plausible) return;
  if (plausible->is_clear && plausible->best < fit.stature.used - kOtherStature) {
    for (const bool away : {false, true}) {
      images[away].changeStature(fit.body[away], plausible->best);
      fit.body[away] = usualBody(plausible->best);
    }
    fit.stature.used = plausible->best;
  }
  fit.stature.narrow(plausible->range);
}

TrackedPerson::Fit TrackedPerson::fit(BySide<BodyCalibration> images, const Fit& start) {
  Fit fit = start;
  BodyCalibration& assumed = images[fit.facing.away];
  const std::optional<bool> on_front = assumed.lyingOnFront();
  if (on_front && !fit.compared && !fit.facing.decided()) decideLying(assumed, *on_front, fit);
  if (!fit.stature.known()) decideStature(images, fit);
  if (fit.compared)
    for (const bool away : {false, true}) fit.body[away] = images[away].fit(fit.body[away]);
  else
    fit.body.fill(assumed.fit(fit.body[0]));
  return fit;
}

void TrackedPerson::adopt(const Fit& fit) {
  const bool is_other = std::abs(fit.stature.used - stature_.used) > kOtherStature;
  stature_ = fit.stature;
  // A comparison that began after the fit counts.
  const bool decides_lying = fit.facing.lies && !compared_;
  if (decides_lying) facing_ = fit.facing;
  const TrackedBody last = now_.tracker->body();
  const Lying lying = now_.tracker->lying();
  now_ = continued(now_, fit.body[facing_.away], facing_.away);
  if (other_) other_ = continued(other_, fit.body[!facing_.away], !facing_.away);
  if (decides_lying && fit.turned) {
    now_.held = HeldThings();  // learned with the arms on the wrong side
    if (last.found) now_.tracker->resume(flippedFacing(*now_.rig, last.pose), lying);
  }
  fitted_ = true;
  if (is_other && decides_ && !facing_.given) compareAgain();
}

/// The facing directions, with another body: what the one before has decided does not count.
void TrackedPerson::compareAgain() {
  facing_.ratio = kNaN;
  trial_ = {};
  other_ = {};
  compared_ = false;
  now_.tracker->setFacingKnown(false);
}

}  // namespace abstand::tracking
