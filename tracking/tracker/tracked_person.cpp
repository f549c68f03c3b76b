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

}  // namespace

TrackedPerson::TrackedPerson(const Options& options) : options_{options} {
  facing_.away = options.away.value_or(false);
  facing_.given = options.away.has_value();
  if (!options.height) return;
  stature_ = Stature::given(*options.height);
  use(usualBody(stature_.used));
  fitted_ = !options.fit_body;
}

TrackedPerson::TrackedPerson(const Options& options, const KnownBody& known)
    : options_{options},
      facing_{known.facing},
      stature_{known.stature},
      things_{known.things},
      held_{known.held} {
  use(known.body);
  started_ = fitted_ = true;
}

TrackedPerson::Follower TrackedPerson::followerOf(const humanmodel::HumanOptions& body,
                                                  const Stature& stature) const {
  Follower follower{body, std::make_unique<BodyRig>(makeRig(humanmodel::makeHuman(body))), nullptr};
  follower.tracker = std::make_unique<BodyTracker>(*follower.rig, options_.seed);
  follower.tracker->setStatureDeviation(stature.deviation());
  if (facing_.away) follower.tracker->expectAway();
  if (facing_.lies) follower.tracker->expectLying(facing_.away);
  follower.tracker->setFacingKnown(facing_.decided());
  return follower;
}

void TrackedPerson::use(const humanmodel::HumanOptions& body) { adopt(followerOf(body, stature_)); }

void TrackedPerson::adopt(Follower follower) {
  body_ = follower.body;
  tracker_ = std::move(follower.tracker);  // before the rig that the last one refers to
  rig_ = std::move(follower.rig);
}

const TrackedBody* TrackedPerson::see(double t, std::span<const PersonImage> images) {
  const TrackedBody* body = follow(t, things_.remove(images));
  if (body && body->found) {
    things_.learn(tracker_->seen(), tracker_->fit(), body->X_WS);
    held_.see(tracker_->seen(), tracker_->fit(), body->X_WS, body->visible);
    tracker_->widenHands(held_.extent());
  }
  return body;
}

TrackedBody TrackedPerson::seeBefore(double t, std::span<const PersonImage> images) {
  if (!before_.tracker) {
    before_ = followerOf(*body_, stature_);
    before_.tracker->resume(tracker_->body().pose, tracker_->lying(), -tracker_->body().frame.t);
  }
  before_.tracker->track(-t, things_.remove(images));
  before_.tracker->widenHands(held_.extent());
  TrackedBody body = before_.tracker->body();
  body.frame.t = t;
  return body;
}

const TrackedBody* TrackedPerson::follow(double t, std::span<const PersonImage> images) {
  bool is_tracked = false;
  if (!started_) {
    coming_.see(t, images);
    if (!tracker_) measure(images);
    if (coming_.isGrowing() || (!tracker_ && extents_.size() < kMeasured)) return nullptr;
    started_ = true;
  }
  if (!tracker_) {
    settle();
    is_tracked = checkUpright(t, images);
  }
  const TrackedBody* body = is_tracked ? &tracker_->body() : &tracker_->track(t, images);
  if (!stature_.known() && !fitting_.valid() && remeasure(images)) return &tracker_->track(t, images);
  if (fitted_) return body;
  if (!fitting_.valid()) {
    calibration_.add(t, *tracker_);
    if (!calibration_.complete()) return body;
    if (options_.fit_aside)
      fitting_ = std::async(std::launch::async, fit, std::move(calibration_),
                            Fit{*body_, facing_, stature_, tracker_->lying().front_over_back, options_.seed});
  }
  if (fitting_.valid() && fitting_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return body;
  settle();
  return &tracker_->track(t, images);
}

/// Keeps the last images that show the person's height.
void TrackedPerson::measure(std::span<const PersonImage> images) {
  const VerticalExtent extent = verticalExtent(images);
  if (extent.height <= 0.0) return;
  if (extents_.size() == kMeasured) extents_.erase(extents_.begin());
  extents_.push_back(extent);
}

/// A tall person on a chair is as high as a short one who stands: if the first image is explained better by a
/// body of usual size, the stature is an interval after all. Returns whether the image was tracked for it.
bool TrackedPerson::checkUpright(double t, std::span<const PersonImage> images) {
  if (stature_.source != Stature::Source::kMeasured || stature_.used > Stature::kTallestSeated) return false;
  const double upright_cost = tracker_->track(t, images).misfit.cost;
  const Stature seated = Stature::ofSeated(stature_.used);
  Follower trial = followerOf(usualBody(seated.used), seated);
  const TrackedBody& found = trial.tracker->track(t, images);
  if (!found.found || found.misfit.cost >= kSeatedCost * upright_cost) return true;
  stature_ = seated;
  adopt(std::move(trial));
  return true;
}

bool TrackedPerson::standsUpright() const {
  using enum humanmodel::Joint;
  const humanmodel::SkeletonFrame& frame = tracker_->body().frame;
  if (!tracker_->body().found) return false;
  const double low =
      std::min({frame[kAnkleLeft].z(), frame[kAnkleRight].z(), frame[kToeLeft].z(), frame[kToeRight].z()});
  return frame[kHeadTop].z() - low > kUpright * rig_->height;
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
  const RigPose last = tracker_->body().pose;
  use(usualBody(stature_.used));
  tracker_->resume(last, {});  // who stands upright
  calibration_ = BodyCalibration{};
  fitted_ = !options_.fit_body;
  return true;
}

void TrackedPerson::settle() {
  if (!tracker_) {
    if (extents_.empty()) return;
    stature_ = measureStature(extents_);
    use(usualBody(stature_.used));
    fitted_ = !options_.fit_body;
  } else if (!fitted_) {
    adopt(fitting_.valid()
              ? fitting_.get()
              : fit(std::move(calibration_),
                    {*body_, facing_, stature_, tracker_->lying().front_over_back, options_.seed}));
  }
}

void Facing::decide(double turning, double searching) {
  if (std::isnan(searching)) searching = 1.0;
  const bool agree = searching != 1.0 && (searching < 1.0) == (turning < 1.0);
  if (!agree)
    ratio = 1.0;
  else if (lies && std::abs(std::log(searching)) < std::abs(std::log(turning)))
    ratio = searching;
  else
    ratio = turning;
  // Neither side is the likelier one of people who lie.
  away = (agree && !lies ? ratio : turning * searching) < (lies ? 1.0 : kBackBelow);
}

void TrackedPerson::decideFacing(const BodyCalibration& images, Fit& fit) {
  const std::optional<bool> on_front = images.lyingOnFront();
  const bool is_away = on_front.value_or(false);
  const double turned = images.whenTurned(fit.body);
  fit.facing.lies = on_front.has_value();
  fit.facing.decide(is_away ? 1.0 / turned : turned,
                    on_front ? fit.front_over_back : images.whenSearchedTurned(fit.body, fit.seed));
  fit.turned = fit.facing.away != is_away;
}

TrackedPerson::Fit TrackedPerson::fit(BodyCalibration images, const Fit& start) {
  Fit fit = start;
  if (!fit.facing.decided()) {
    decideFacing(images, fit);
    if (fit.turned) images.flipFacing(fit.body);
  }
  if (!fit.stature.known())
    if (const auto range = images.plausibleStatures(fit.body, fit.stature.interval))
      fit.stature.narrow(*range);
  fit.body = images.fit(fit.body);
  return fit;
}

void TrackedPerson::adopt(const Fit& fit) {
  facing_ = fit.facing;
  stature_ = fit.stature;
  const TrackedBody last = tracker_->body();
  const Lying lying = tracker_->lying();
  use(fit.body);
  if (fit.turned) held_ = HeldThings();  // learned with the arms on the wrong side
  if (last.found) tracker_->resume(fit.turned ? flippedFacing(*rig_, last.pose) : last.pose, lying);
  fitted_ = true;
}

}  // namespace abstand::tracking
