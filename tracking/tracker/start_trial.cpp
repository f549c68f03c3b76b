#include "tracking/tracker/start_trial.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace abstand::tracking {
namespace {

constexpr double kLatestPath = 1.0;    // s, of a start on the path after the first search
constexpr double kLostCost = 3.0;      // times the usual cost, of an image in which a candidate is lost
constexpr double kTypicalCost = 3e-4;  // m^2, if the usual one is unknown
// Images in which a body that faces the other way may be searched for in vain: each search takes as long as
// ten images, and several cameras mostly refute that body at once.
constexpr int kVainSearches = 2;

/// The same person facing the other way all the time.
std::shared_ptr<const KnownBody> turned(const KnownBody& known) {
  auto turned = std::make_shared<KnownBody>(known);
  turned->facing.away = !known.facing.away;
  turned->facing.ratio = kNaN;
  turned->assumed.path.turn();
  std::swap(turned->assumed.held[0], turned->assumed.held[1]);
  return turned;
}

}  // namespace

StartTrial::StartTrial(const TrackedPerson::Options& options, std::shared_ptr<const KnownBody> known,
                       double start, double usual_cost)
    : options_{options},
      known_{std::move(known)},
      start_{start},
      lost_cost_{kLostCost * (std::isfinite(usual_cost) ? usual_cost : kTypicalCost)} {
  for (std::size_t k = 0; k < kSearches; ++k)
    starts_.push_back({start + kEvery * static_cast<double>(k), false, k});
  const double on_path = known_->assumed.path.start();
  if (on_path < start + kLatestPath && !known_->facing.lies)
    starts_.push_back({std::max(start, on_path), true, kSearches});
  for (const Start& one : starts_) counted_from_ = std::max(counted_from_, one.t);
}

void StartTrial::add(std::vector<KeptMoment> moments) {
  std::move(moments.begin(), moments.end(), std::back_inserter(moments_));
}

bool StartTrial::extend() {
  if (counted_ == kCountedLonger) return false;
  counted_ = kCountedLonger;
  return true;
}

StartTrial::Result StartTrial::run() const {
  Result best;
  for (const Start& start : starts_) compete(start, known_, std::numeric_limits<int>::max(), best);
  Result other;
  if (mayFaceOtherWay()) other = bestOfOtherWay(best.cost);
  continueBefore(best);
  if (!other.tracker) return best;
  continueBefore(other);
  revise(std::move(other), best);
  return best;
}

bool StartTrial::mayFaceOtherWay() const {
  const Facing& facing = known_->facing;
  return facing.decided() && !facing.given && !facing.lies;
}

/// The best body that faces the other way and refutes one of this cost; no tracker if there is none.
StartTrial::Result StartTrial::bestOfOtherWay(double cost) const {
  const auto other_way = turned(*known_);
  Result refuting;
  refuting.cost = kRefuted * cost;
  for (const Start& start : starts_)
    if (!start.on_path) compete(start, other_way, kVainSearches, refuting);
  return refuting;
}

/// What both passes say together: the first one compared more images, but from a wrong first pose, perhaps. A
/// longer trial compares as many, from the best of several first poses.
void StartTrial::revise(Result other, Result& best) const {
  const bool away = !known_->facing.away;
  const double trial = away ? other.cost / best.cost : best.cost / other.cost;
  const auto counted = std::count_if(moments_.begin(), moments_.end(),
                                     [this](const KeptMoment& moment) { return moment.t >= counted_from_; });
  const bool decides_alone = counted >= static_cast<std::ptrdiff_t>(FacingTrial::kMinImages);
  const double ratio = decides_alone ? trial : trial * known_->facing.ratio;
  if ((ratio < 1.0) == away) std::swap(best, other);
  best.tracker->reviseFacing(ratio, std::move(*other.tracker));
  if (best.tracker->facing().decided()) return;
  best.contradicts_first = true;
  for (std::size_t i = 0; i < best.bodies.size(); ++i) encloseOtherFacing(other.bodies[i], best.bodies[i]);
}

double StartTrial::costOf(const TrackedBody& body) const {
  return body.found && body.misfit.cost < lost_cost_ ? body.misfit.cost : lost_cost_;
}

/// Tracks a candidate through the moments from its start on, unless it is not found in the first `vain`
/// images. If it costs less than `best`, replaces it.
void StartTrial::compete(const Start& start, const std::shared_ptr<const KnownBody>& known, int vain,
                         Result& best) const {
  TrackedPerson::Options options = options_;
  options.seed += start.seed;
  options.starts_on_path = start.on_path;
  Result candidate{std::make_unique<TrackedPerson>(options, known), {}, 0.0, false};
  candidate.bodies.resize(moments_.size());
  const double counted_from = std::min(counted_from_, moments_.back().t - kCounted);
  bool was_found = false;
  for (std::size_t i = 0; i < moments_.size() && candidate.cost < best.cost; ++i) {
    if (moments_[i].t >= start.t) {
      candidate.bodies[i] = *candidate.tracker->see(moments_[i].t, moments_[i].views());
      was_found = was_found || candidate.bodies[i].found;
      if (!was_found && --vain == 0) return;
    }
    if (moments_[i].t >= counted_from) candidate.cost += costOf(candidate.bodies[i]);
  }
  if (candidate.cost < best.cost) best = std::move(candidate);
}

/// Tracks the body backwards from where it was found first.
void StartTrial::continueBefore(Result& best) const {
  const auto found = std::find_if(best.bodies.begin(), best.bodies.end(),
                                  [](const TrackedBody& body) { return body.found; });
  if (found == best.bodies.end()) return;
  for (auto i = static_cast<std::size_t>(found - best.bodies.begin()); i > 0; --i) {
    const KeptMoment& moment = moments_[i - 1];
    TrackedBody body = best.tracker->seeBefore(moment.t, moment.views());
    if (!body.found && moment.t < start_) return;
    best.bodies[i - 1] = std::move(body);
  }
}

}  // namespace abstand::tracking
