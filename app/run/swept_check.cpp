#include "app/run/swept_check.hpp"

namespace abstand::run {
namespace {

// As near as the check wants to know; a limit is a whole number of millimetres in practice.
constexpr double kTolerance = 1e-4;
constexpr int kMaxSamples = 256;

safety::DistanceSample sampleOf(const query::PairResult& r) { return {r.distance - r.bound, r.distance}; }

}  // namespace

void SweptCheck::begin(double t, const std::vector<query::PairResult>& results) {
  t_ = t;
  poses_.clear();
  distances_.clear();
  for (const scene::Object& object : scene_.objects()) poses_.push_back(object.X_WB);
  for (const query::PairResult& r : results) distances_.push_back(sampleOf(r));
  between_.assign(results.size(), {});
  memories_.resize(results.size());
}

std::span<const SweptCheck::Between> SweptCheck::frame(double t,
                                                       const std::vector<query::PairResult>& results,
                                                       std::span<const double> limits) {
  if (!(t > t_)) {
    begin(t, results);
    return between_;
  }
  const double duration = t - t_;
  const std::vector<scene::Object>& objects = scene_.objects();
  motions_.clear();
  for (std::size_t i = 0; i < objects.size(); ++i)
    motions_.emplace_back(objects[i].spec.structure->bounding_sphere, poses_[i], objects[i].X_WB, duration);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const scene::Pair& pair = scene_.pairs()[i];
    safety::PoseSegment &a = motions_[pair.a.index()], &b = motions_[pair.b.index()];
    const safety::DistanceSample now = sampleOf(results[i]);
    const double rate = a.speed(0.0, duration) + b.speed(0.0, duration);
    Between& between = between_[i];
    between = {t, safety::leastBetween(distances_[i].lower, now.lower, rate, duration),
               std::min(distances_[i].upper, now.upper)};
    if (!(between.lower >= limits[i]) && rate > 0.0) {
      safety::SweptOptions options;
      options.tolerance = kTolerance;
      options.enough = limits[i];
      options.max_samples = kMaxSamples;
      scratch_.memory = memories_[i];
      const structure::HapticStructure &sa = *objects[pair.a.index()].spec.structure,
                                       &sb = *objects[pair.b.index()].spec.structure;
      const safety::SweptResult swept = safety::sweptPair({sa, a}, {sb, b}, duration, options, scratch_);
      memories_[i] = scratch_.memory;
      queries_ += swept.samples;
      between.lower = std::max(between.lower, swept.lower);
      if (swept.upper < between.upper) between.upper = swept.upper, between.t = t_ + swept.t;
    }
    distances_[i] = now;
  }
  for (std::size_t i = 0; i < objects.size(); ++i) poses_[i] = objects[i].X_WB;
  t_ = t;
  return between_;
}

}  // namespace abstand::run
