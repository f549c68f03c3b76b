// Measure, fit, follow.
#include "tracking/tracker/tracked_person.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kMeasured = 15;  // images
constexpr double kSeatedCost = 0.8;    // times that of the upright body, below which the person sits
constexpr double kUpright = 0.96;      // share of the stature between sole and vertex of who stands upright
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

}  // namespace

TrackedPerson::TrackedPerson(const Options& options) : options_{options} {
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
  const std::span<const PersonImage> images = things_.remove(all);
  if (other_ && t - found_t_ > BodyTracker::kTurns) endComparison();
  if (!follow(t, images)) return nullptr;
  if (now_.tracker->body().found) found_t_ = t;
  compareFacings(t, images);
  const TrackedBody& body = renewBody(t, images) ? track(t, images) : now_.tracker->body();
  if (body.found) things_.learn(now_.tracker->seen(), now_.tracker->fit(), body.X_WS);
  now_.learn();
  if (other_) {
    other_.learn();
    includeOther();
  }
  return &body;
}

/// Both facing directions count while the images do not decide.
void TrackedPerson::includeOther() {
  const TrackedBody &body = now_.tracker->body(), &other = other_.tracker->body();
  if (body.found) now_.tracker->encloseOther(other.found ? other.frame : flippedFacing(body.frame));
}

TrackedBody TrackedPerson::seeBefore(double t, std::span<const PersonImage> images,
                                     const TrackedBody& first) {
  if (!before_) {
    before_ = followerOf(now_.body, stature_, facing_.away);
    before_.tracker->resume(first.pose, now_.tracker->lying(), -first.frame.t);
  }
  before_.track(-t, things_.remove(images));
  before_.tracker->widenHands(now_.held.extent());
  TrackedBody body = before_.tracker->body();
  body.frame.t = t;
  return body;
}

/// Measures the person, then tracks the body that faces as assumed. Returns whether it was tracked.
bool TrackedPerson::follow(double t, std::span<const PersonImage> images) {
  if (!started_) {
    coming_.see(t, images);
    if (!now_) measure(images);
    if (coming_.isGrowing() || (!now_ && extents_.size() < kMeasured)) return false;
    started_ = true;
  }
  if (!now_) {
    makeMeasured();
    if (checkUpright(t, images)) return true;
  }
  track(t, images);
  return true;
}

/// All bodies; returns the one that faces as assumed.
const TrackedBody& TrackedPerson::track(double t, std::span<const PersonImage> images) {
  if (known_) {
    expect(known_->assumed.path, t, options_.starts_on_path, *now_.tracker);
    if (known_->other) expect(known_->other->path, t, options_.starts_on_path, *other_.tracker);
  }
  if (other_) now_.tracker->setFacingKnown(other_.track(t, images).found && !now_.tracker->lying().lies);
  const TrackedBody& body = now_.track(t, images);
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

/// A tall person on a chair is as high as a short one who stands: if the first image is explained better by a
/// body of usual size, the stature is an interval after all. Returns whether the image was tracked for it.
bool TrackedPerson::checkUpright(double t, std::span<const PersonImage> images) {
  if (stature_.source != Stature::Source::kMeasured || stature_.used > Stature::kTallestSeated) return false;
  const double upright_cost = now_.track(t, images).misfit.cost;
  const Stature seated = Stature::ofSeated(stature_.used);
  BodyFollower trial = followerOf(usualBody(seated.used), seated, facing_.away);
  const TrackedBody& found = trial.track(t, images);
  if (!found.found || found.misfit.cost >= kSeatedCost * upright_cost) return true;
  stature_ = seated;
  now_ = std::move(trial);
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
    BySide<double> cost;
    cost[facing_.away] = mine.misfit.cost;
    cost[!facing_.away] = its.misfit.cost;
    trial_.add(cost[false], cost[true]);
    trial_.judge(facing_);
    assume(facing_.decided() ? facing_.ratio < 1.0 : trial_.isLikelyAway());
  }
  if (facing_.decided()) endComparison();
}

void TrackedPerson::assume(bool away) {
  if (away == facing_.away) return;
  facing_.away = away;
  std::swap(now_, other_);
}

void TrackedPerson::endComparison() {
  other_ = {};
  calibration_[!facing_.away] = {};
  now_.tracker->setFacingKnown(facing_.decided());
}

/// Measures again, or fits. Returns whether there is a new body, which has tracked nothing yet.
bool TrackedPerson::renewBody(double t, std::span<const PersonImage> images) {
  if (!stature_.known() && !fitting_.valid() && remeasure(images)) return true;
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

bool TrackedPerson::standsUpright() const {
  using enum humanmodel::Joint;
  const TrackedBody& body = now_.tracker->body();
  if (!body.found) return false;
  const humanmodel::SkeletonFrame& frame = body.frame;
  const double low =
      std::min({frame[kAnkleLeft].z(), frame[kAnkleRight].z(), frame[kToeLeft].z(), frame[kToeRight].z()});
  return frame[kHeadTop].z() - low > kUpright * now_.rig->height;
}

bool TrackedPerson::remeasure(std::span<const PersonImage> images) {
  if (!standsUpright()) {
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

TrackedPerson::Fit TrackedPerson::fit(BySide<BodyCalibration> images, const Fit& start) {
  Fit fit = start;
  BodyCalibration& assumed = images[fit.facing.away];
  const std::optional<bool> on_front = assumed.lyingOnFront();
  if (on_front && !fit.compared && !fit.facing.decided()) decideLying(assumed, *on_front, fit);
  if (!fit.stature.known())
    if (const auto range = assumed.plausibleStatures(fit.body[0], fit.stature.interval))
      fit.stature.narrow(*range);
  if (fit.compared)
    for (const bool away : {false, true}) fit.body[away] = images[away].fit(fit.body[away]);
  else
    fit.body.fill(assumed.fit(fit.body[0]));
  return fit;
}

void TrackedPerson::adopt(const Fit& fit) {
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
}

}  // namespace abstand::tracking
