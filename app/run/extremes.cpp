#include "app/run/extremes.hpp"

namespace abstand::run {

Extremes::Extremes(const session::Session& session)
    : session_(session), touching_(session.scene().pairs().size(), false), classes_(pairClasses(session)) {}

void Extremes::frame(double t, const std::vector<query::PairResult>& results,
                     const std::vector<PairId>& updated, RunSummary& summary) {
  for (const PairId id : updated) {
    const std::size_t i = id.index();
    const query::PairResult& r = results[i];
    const double age = session_.scene().ageOf(id, t);
    if (age > age_ || (age == age_ && t == age_t_ && i < age_pair_)) {
      age_ = age;
      age_pair_ = i;
      age_t_ = t;
    }
    distance_.offer(r.distance, t, i);
    if (classes_[i] != PairClass::kOther)
      least_[static_cast<std::size_t>(classes_[i])].offer(r.distance, t, i);
    lookAtClearance(id, t, r);
    const double force = r.force_a.norm();
    if (force > force_ || (force == force_ && t == force_t_ && i < force_pair_)) {
      force_ = force;
      force_pair_ = i;
      force_t_ = t;
      force_apart_ = r.distance > r.bound;
    }
    const bool touches = r.contacts > 0;
    if (touches != touching_[i]) touching_count_ += touches ? 1 : -1;
    touching_[i] = touches;
  }
  summary.contacts += touching_count_;
  // The uncertainty of unseen bodies grows even if no result was updated.
  const scene::Scene& scene = session_.scene();
  for (std::uint32_t i = 0; i < scene.objectCount(); ++i)
    if (scene.object(ObjectId(i)).pose_uncertainty > 0.0)
      for (const PairId id : scene.pairsOf(ObjectId(i))) lookAtClearance(id, t, results[id.index()]);
}

void Extremes::finish(RunSummary& summary, RunMode mode) const {
  if (mode == RunMode::kLive && age_ >= 0.0) summary.oldest_result = extreme(age_pair_, age_t_, age_);
  summary.min_distance = extreme(distance_);
  for (std::size_t i = 0; i < least_.size(); ++i) summary.min_distance_by_class[i] = extreme(least_[i]);
  summary.min_clearance = extreme(clearance_);
  summary.peak_force_apart = force_apart_;
  if (force_ > 0.0) summary.peak_force = extreme(force_pair_, force_t_, force_);
}

RunSummary::Extreme Extremes::extreme(std::size_t pair, double t, double value) const {
  const scene::Scene& scene = session_.scene();
  const scene::Pair& p = scene.pairs()[pair];
  return {scene.object(p.a).spec.name, scene.object(p.b).spec.name, t, value};
}

std::optional<RunSummary::Extreme> Extremes::extreme(const Least& least) const {
  if (!(least.value < kInfinity)) return {};
  return extreme(least.pair, least.t, least.value);
}

}  // namespace abstand::run
