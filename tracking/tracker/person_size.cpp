// Stature and body of a person: measured, fitted, measured again.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "tracking/tracker/head_peak.hpp"
#include "tracking/tracker/other_posture.hpp"
#include "tracking/tracker/tracked_person.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

// Times that of the upright body, below which the person sits, or raises the arms. Of simulated people with
// raised arms, the right stature cost at most 0.72 times as much as the wrong one; of others, the wrong one
// at least 0.95, and 0.8 with a hand at the head.
constexpr double kOtherCost = 0.8;
// Likewise of who stoops: measured 0.49 to 0.54; of boxers, who stand with bent legs, 0.79. And of who
// kneels: 0.30; of a real person of 1.54 m who stands, more than 0.5.
constexpr double kLoweredCost = 0.65, kKneelingCost = 0.5;
// Share of the points that the assumed body does not explain, of which a lower posture leaves less: its arms
// explain a bucket or a tray that somebody carries, and then leave 0.5 to 0.7 of them; true ones, 0.2 to 0.3.
constexpr double kLeavesUnexplained = 0.5;
constexpr double kOtherStature = 0.1;  // m; the evidence of a body that is so wrong does not count
constexpr double kHigher = 0.06;       // m, above the measured stature: hair, and the noise of a Kinect
constexpr double kFeetOnFloor = 0.10;  // m, of ankles and toes
constexpr double kSteady = 0.04;       // m, largest difference of the heights of images that are measured

/// Whether the body `other` in this posture explains the image so much better than the assumed one, which is
/// `height` (m) tall.
bool isLikelier(const OtherPosture& posture, const DepthMisfit& other, double height,
                const DepthMisfit& assumed) {
  using enum OtherPosture::Kind;
  const OtherPosture::Kind kind = posture.kind;
  const double cost = kind == kKneeling ? kKneelingCost : kind == kLowered ? kLoweredCost : kOtherCost;
  const bool is_upright = kind == kRaisedArms || kind == kChild;
  // Somebody short whose raised hand is the highest would otherwise be a giant who sits.
  const double rarer = is_upright ? 1.0 : Stature::unusual(posture.stature.used) / Stature::unusual(height);
  if (std::max(1.0, rarer) * other.cost >= cost * assumed.cost) return false;
  return is_upright || 1.0 - other.explained < kLeavesUnexplained * (1.0 - assumed.explained);
}

}  // namespace

/// Keeps the last images that show the person's height.
void TrackedPerson::measure(std::span<const PersonImage> images) {
  const VerticalExtent extent = verticalExtent(images);
  if (extent.height <= 0.0) return;
  if (extents_.size() == kMeasured) extents_.erase(extents_.begin());
  extents_.push_back(extent);
  BodyObservation seen;
  seen.update(images);
  extents_.back().head = headBelowHands(seen).value_or(kNaN);
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
  const double height = stature_.used;
  double best = kInfinity;
  std::array<double, 2> interval{kInfinity, -kInfinity};
  for (const OtherPosture& other : otherPostures(stature_)) {
    BodyFollower trial = followerOf(usualBody(other.stature.used), other.stature, facing_.away);
    trial.tracker->allowChair(false);  // the upright body explains all points, too
    const TrackedBody& found = trial.track(t, images);
    trial.tracker->allowChair(true);
    if (!found.found || !isLikelier(other, found.misfit, height, assumed) ||
        !isIn(other.kind, found.frame, *trial.rig))
      continue;
    interval = {std::min(interval[0], other.stature.interval[0]),
                std::max(interval[1], other.stature.interval[1])};
    if (found.misfit.cost >= best) continue;
    best = found.misfit.cost;
    stature_ = other.stature;
    now_ = std::move(trial);
  }
  if (!stature_.known() && best < kInfinity) stature_.interval = interval;
  return true;
}

/// Measures again, or fits. Returns whether there is a new body, which has tracked nothing yet.
bool TrackedPerson::renewBody(double t, std::span<const PersonImage> images) {
  const bool is_given = stature_.source == Stature::Source::kGiven;
  if (!is_given && !fitting_.valid() && remeasure(t, images)) return true;
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

/// Of a person who is higher than the measured stature, and may have stepped on something: whether the feet
/// are on the floor, or the body of the higher stature explains the image better.
bool TrackedPerson::isTaller(const Stature& higher, double t, std::span<const PersonImage> images) const {
  const TrackedBody& body = now_.tracker->body();
  if (lowestFoot(body.frame) < kFeetOnFloor) return true;
  BodyFollower trial = followerOf(usualBody(higher.used), higher, facing_.away);
  trial.tracker->expectFacing(yawOf(body.pose));
  const TrackedBody& found = trial.track(t, images);
  return found.found && found.misfit.cost < kOtherCost * body.misfit.cost;
}

bool TrackedPerson::remeasure(double t, std::span<const PersonImage> images) {
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
  if (stature_.known() && (measured.used < stature_.used + kHigher || !isTaller(measured, t, images))) {
    extents_.clear();
    return false;
  }
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
