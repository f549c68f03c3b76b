#include "app/run/swept_check.hpp"

#include <cmath>

namespace abstand::run {
namespace {

// m; accuracy of the check. Limits are whole millimetres in practice.
constexpr double kTolerance = 1e-4;
constexpr int kMaxSamples = 256;

// m: results of frames with wider bounds, as culling leaves them, are queried again.
constexpr double kSharp = 1e-3;

/// False for NaN.
bool isSharp(const safety::SweptEnds& ends) {
  return ends.first.upper - ends.first.lower <= kSharp && ends.last.upper - ends.last.lower <= kSharp;
}

safety::DistanceSample sampleOf(const query::PairResult& r) { return {r.distance - r.bound, r.distance}; }

}  // namespace

SweptCheck::SweptCheck(const scene::Scene& scene) : scene_(scene) {
  for (std::uint32_t i = 0; i < scene.pairs().size(); ++i) pairs_.emplace_back(i);
}

void SweptCheck::begin(double t, const std::vector<query::PairResult>& results) {
  t_ = t;
  poses_.clear();
  distances_.clear();
  motions_.clear();
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
  speeds_.clear();
  for (const safety::PoseSegment& motion : motions_) speeds_.push_back(motion.speed(0.0, duration));
  for (const PairId id : pairs_) {
    const std::size_t i = id.index();
    const scene::Pair& pair = scene_.pairs()[i];
    safety::PoseSegment &a = motions_[pair.a.index()], &b = motions_[pair.b.index()];
    const safety::DistanceSample now = sampleOf(results[i]);
    const double rate = speeds_[pair.a.index()] + speeds_[pair.b.index()];
    Between& between = between_[i];
    between = {t, safety::minBetween(distances_[i].lower, now.lower, rate, duration),
               std::min(distances_[i].upper, now.upper)};
    // A pair that was not queried has no bound; NaN from others is no bound either.
    if (std::isnan(between.lower)) between.lower = -kInfinity;
    if (limits[i] > -kInfinity && !(between.lower >= limits[i]) && rate > 0.0) {
      safety::SweptOptions options;
      options.tolerance = kTolerance;
      options.enough = limits[i];
      options.max_samples = kMaxSamples;
      const structure::HapticStructure &sa = *objects[pair.a.index()].spec.structure,
                                       &sb = *objects[pair.b.index()].spec.structure;
      const safety::SweptEnds ends{distances_[i], now};
      const safety::SweptResult swept =
          safety::sweptPair({sa, a}, {sb, b}, duration, options,
                            safety::SweptContext{memories_[i], scratch_.scratch, scratch_.result,
                                                 isSharp(ends) ? &ends : nullptr});
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
