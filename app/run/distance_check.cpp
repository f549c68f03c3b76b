#include "app/run/distance_check.hpp"

#include <algorithm>

#include "app/run/cold_query.hpp"

namespace abstand::run {
namespace {

void takeSmaller(std::optional<RunSummary::Extreme>& least, const std::optional<RunSummary::Extreme>& e) {
  if (e && (!least || e->value < least->value)) least = e;
}

}  // namespace

DistanceCheck::DistanceCheck(const scene::Scene& scene, double limit, bool with_margins, bool swept,
                             std::string recording)
    : scene_(scene),
      recording_(std::move(recording)),
      broken_(scene.pairs().size()),
      unproven_(scene.pairs().size()) {
  for (const scene::Pair& pair : scene.pairs())
    limits_.push_back(with_margins ? std::max(limit, pair.options.margin) : limit);
  if (swept) swept_.emplace(scene);
  uncertainties_.assign(limits_.size(), 0.0);
  widened_ = limits_;
}

void DistanceCheck::watch(Open& open, std::vector<Violation>& closed, const Sample& at, bool broken) {
  if (!broken) {
    if (open.active) closed.push_back(open.violation);
    open.active = false;
    return;
  }
  if (!open.active) {
    const scene::Pair& p = scene_.pairs()[at.pair];
    open = {true,
            {scene_.object(p.a).spec.name, scene_.object(p.b).spec.name, at.t, at.t, at.distance,
             limits_[at.pair], at.uncertainty, recording_}};
  }
  open.violation.end = at.t;
  open.violation.uncertainty = std::max(open.violation.uncertainty, at.uncertainty);
  open.violation.min_distance = std::min(open.violation.min_distance, at.distance);
}

safety::ClearanceVerdict DistanceCheck::verdictOf(const query::PairResult& result, std::size_t pair) const {
  return safety::verdict({result.distance, result.bound, uncertainties_[pair]}, limits_[pair]);
}

void DistanceCheck::frame(double t, const std::vector<query::PairResult>& results) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    const double uncertainty = scene_.pairUncertainty(PairId(static_cast<std::uint32_t>(i)));
    widened_[i] = limits_[i] + std::max(uncertainty, uncertainties_[i]);
    uncertainties_[i] = uncertainty;
  }
  const std::span<const SweptCheck::Between> between =
      swept_ ? swept_->frame(t, results, widened_) : std::span<const SweptCheck::Between>();
  for (std::size_t i = 0; i < results.size(); ++i) {
    double d = results[i].distance, when = t;
    const safety::ClearanceVerdict now = verdictOf(results[i], i);
    bool broken = now == safety::ClearanceVerdict::kBroken, proven = now == safety::ClearanceVerdict::kKept;
    if (!between.empty()) {
      // Between frames the wider of their limits applies.
      broken = broken || !(between[i].upper >= widened_[i]);
      proven = proven && between[i].lower >= widened_[i];
      if (between[i].upper < d) d = between[i].upper, when = between[i].t;
    }
    // A warm start may leave a distance above the smallest one, with a wide bound: a cold query decides.
    if (scene_.culling().remember && !broken &&
        (!proven || d * (1.0 - scene_.culling().far_tolerance) < limits_[i] + uncertainties_[i])) {
      const query::PairResult cold = queryCold(scene_, scene_.pairs()[i], scratch_);
      if (cold.distance < d) d = cold.distance, when = t;
      const safety::ClearanceVerdict certain = verdictOf(cold, i);
      broken = broken || certain == safety::ClearanceVerdict::kBroken;
      const bool between_proven = between.empty() || between[i].lower >= widened_[i];
      proven = proven || (certain == safety::ClearanceVerdict::kKept && between_proven);
    }
    const double uncertainty = between.empty() ? uncertainties_[i] : widened_[i] - limits_[i];
    watch(broken_[i], closed_broken_, {i, when, d, uncertainty}, broken);
    watch(unproven_[i], closed_unproven_, {i, when, d, uncertainty}, !broken && !proven);
  }
}

void DistanceCheck::finish(const RunSummary& summary, CheckResult& all) {
  const auto close = [](std::vector<Open>& open, std::vector<Violation>& closed,
                        std::vector<Violation>& into) {
    for (Open& o : open)
      if (o.active) closed.push_back(o.violation);
    open.clear();
    std::stable_sort(closed.begin(), closed.end(),
                     [](const auto& x, const auto& y) { return x.start < y.start; });
    into.insert(into.end(), closed.begin(), closed.end());
  };
  close(broken_, closed_broken_, all.violations);
  close(unproven_, closed_unproven_, all.unproven);
  all.frames += summary.frames;
  takeSmaller(all.min_distance, summary.min_distance);
  for (std::size_t i = 0; i < all.min_distance_by_class.size(); ++i)
    takeSmaller(all.min_distance_by_class[i], summary.min_distance_by_class[i]);
  if (swept_) all.swept_queries += swept_->queries();
  std::vector<Reservation> reservations = summary.reservations;
  for (Reservation& r : reservations) r.recording = recording_;
  addReservations(all.reservations, reservations);
  for (const auto& name : summary.stale)
    if (std::find(all.stale.begin(), all.stale.end(), name) == all.stale.end()) all.stale.push_back(name);
}

bool passed(const CheckResult& result, bool strict) {
  if (!result.violations.empty() || (strict && !result.unproven.empty())) return false;
  return std::none_of(result.reservations.begin(), result.reservations.end(),
                      [strict](const Reservation& r) { return failing(r, strict); });
}

}  // namespace abstand::run
