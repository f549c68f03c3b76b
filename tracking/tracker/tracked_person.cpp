// Start, follow, compare facing directions.
#include "tracking/tracker/tracked_person.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

// m^2: the bodies of people who stand cost less, without things that touch them.
constexpr double kDoubtfulCost = 5e-4;
// Times the cost of a body found without these things, below which the followed one goes on.
constexpr double kFollowedCost = 1.3;
constexpr Backoff::Waits kSeparations{1, 0.5, 2.0, 4.0};

/// A body that was on this path at `t` (s) starts on it, or is searched for.
void expect(const BodyPath& path, double t, bool starts_on_path, BodyTracker& tracker) {
  const BodyPath::Point* point = path.nearest(t);
  if (!point) return;
  if (starts_on_path)
    tracker.resume(point->pose, {}, t);
  else
    tracker.expectFacing(yawOf(point->pose));
}

/// `now` and, if there is one, `other`, which faces the other way; `decided`: it does not count. Returns the
/// body of `now`.
const TrackedBody& trackBoth(double t, std::span<const PersonImage> images, bool decided, BodyFollower& now,
                             BodyFollower& other) {
  if (other) {
    const bool is_found = other.track(t, images).found;
    now.tracker->setFacingKnown((decided || is_found) && !now.tracker->lying().lies);
  }
  return now.track(t, images);
}

}  // namespace

TrackedPerson::TrackedPerson(const Options& options)
    : options_{options}, separations_{kSeparations}, searches_{kSeparations} {
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
      searches_{kSeparations},
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
  if (other_ && !facing_.decided()) known.other = side(other_);
  return known;
}

BodyFollower TrackedPerson::followerOf(const humanmodel::HumanOptions& body, const Stature& stature,
                                       bool away) const {
  Facing facing = facing_;
  facing.away = away;
  BodyFollower follower(body, stature, facing, options_.seed);
  follower.tracker->stateSpreads(options_.states_spreads);
  return follower;
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
  searchAnew(t, images);
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
    if (!facing_.decided()) now_.tracker->encloseOther(other_.tracker->body());
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
  trackBoth(-t, things_.remove(all), facing_.decided(), before_, other_before_);
  before_.tracker->widenHands(now_.held.extent());
  if (other_before_) {
    other_before_.tracker->widenHands(other_.held.extent());
    if (!facing_.decided()) before_.tracker->encloseOther(other_before_.tracker->body());
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
  for (const PersonImage& image : images)
    moment.add(image, std::make_shared<const DepthFrame>(DepthFrame{t, *image.image}));
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

/// A body whose feet are in the air, and that explains the image badly: the search of its tracker would start
/// from its own, wrong direction.
void TrackedPerson::searchAnew(double t, std::span<const PersonImage> images) {
  const TrackedBody& body = now_.tracker->body();
  if (!body.found || body.misfit.cost < kDoubtfulCost || !now_.tracker->floats() || !searches_.isDue(t))
    return;
  BodyFollower trial = followerOf(now_.body, stature_, facing_.away);
  const TrackedBody& other = trial.track(t, images);
  const bool is_better =
      other.found && !trial.tracker->floats() && other.misfit.cost < BodyTracker::kFloats * body.misfit.cost;
  searches_.note(t, is_better);
  if (!is_better) return;
  trial_ = {};
  now_.tracker->resume(other.pose, trial.tracker->lying(), t);
  track(t, images);
  things_.forget();
}

/// All bodies; returns the one that faces as assumed.
const TrackedBody& TrackedPerson::track(double t, std::span<const PersonImage> images) {
  if (known_) {
    expect(known_->assumed.path, t, options_.starts_on_path, *now_.tracker);
    if (known_->other) expect(known_->other->path, t, options_.starts_on_path, *other_.tracker);
  }
  const TrackedBody& body = trackBoth(t, images, facing_.decided(), now_, other_);
  if (body.found) known_.reset();
  return body;
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
    if (facing_.decided() && facing_.contradicts())
      facing_.ratio = kNaN;  // decided before a body was replaced
  }
  const bool is_refuted = mine.found && !std::isfinite(its.misfit.cost);
  if (facing_.decided() && (trial_.settles() || is_refuted)) endComparison();
}

/// Bodies that face as assumed, and the other way, in one image. Evidence with wrong poses does not count,
/// nor that of bodies of which one was found anew and faces as the other one does.
void TrackedPerson::addToTrial(double t, const BodyFollower& mine, const BodyFollower& its) {
  if (faceAlike(mine.tracker->body().pose, its.tracker->body().pose)) return;
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

void TrackedPerson::reviseFacing(double ratio, TrackedPerson other) {
  facing_.ratio = ratio;
  now_.tracker->setFacingKnown(facing_.decided());
  if (facing_.decided()) return;
  other_ = std::move(other.now_);
  decides_ = true;
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

}  // namespace abstand::tracking
