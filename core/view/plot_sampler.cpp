#include "core/view/plot_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "core/safety/clearance_verdict.hpp"

namespace abstand::view {

namespace {

void addForce(const query::PairResult& result, PlotSample& sample) {
  double& largest =
      safety::isTouching(result.distance, result.bound) ? sample.contact_force : sample.virtual_force;
  largest = std::max(largest, result.force_a.norm());
}

template <class ClassOf>
void fillFrom(const SceneSnapshot& snapshot, std::size_t pairs, ClassOf class_of, PlotSample& sample) {
  sample.class_distance = kNoDistances;
  sample.min_distance = kInfinity;
  sample.nearest_pair = -1;
  sample.contact_force = sample.virtual_force = 0.0;
  for (std::size_t p = 0; p < pairs; ++p) {
    const PairSnapshot& pair = snapshot.pairs[p];
    if (pair.paused) continue;
    if (pair.result.contacts > 0) addForce(pair.result, sample);
    const double distance = pair.result.distance;
    if (!(distance < kInfinity)) continue;
    double& of_class = sample.class_distance[static_cast<std::size_t>(class_of(p))];
    of_class = std::min(of_class, distance);
    if (!(distance < sample.min_distance)) continue;
    sample.min_distance = distance;
    sample.nearest_pair = static_cast<int>(p);
  }
}

}  // namespace

PlotSampler::PlotSampler(const SceneOutline& outline) {
  std::array<std::size_t, kPairClasses> counts{};
  for (const auto& pair : outline.pairs) {
    classes_.push_back(pairClassOf(outline, pair));
    places_.push_back(counts[static_cast<std::size_t>(classes_.back())]++);
  }
  for (std::size_t of = 0; of < kPairClasses; ++of) distances_[of].resize(counts[of]);
}

void PlotSampler::take(const scene::Scene& scene, std::size_t pair) {
  const scene::Pair& of = scene.pairs()[pair];
  distances_[static_cast<std::size_t>(classes_[pair])].set(places_[pair],
                                                           of.paused ? kInfinity : of.result.distance);
}

void PlotSampler::fill(const scene::Scene& scene, PlotSample& sample) {
  const long steps = scene.steps();
  if (steps == steps_ + 1 && steps_ >= 0) {
    for (const PairId id : scene.updated()) take(scene, id.index());
  } else if (steps != steps_) {
    for (std::size_t pair = 0; pair < classes_.size(); ++pair) take(scene, pair);
  }
  steps_ = steps;
  for (std::size_t of = 0; of < kPairClasses; ++of) sample.class_distance[of] = distances_[of].minimum();
  sample.min_distance = kInfinity;
  sample.nearest_pair = -1;
  if (const auto nearest = scene.nearest()) {
    sample.min_distance = scene.result(*nearest).distance;
    sample.nearest_pair = static_cast<int>(nearest->index());
  }
  sample.contact_force = sample.virtual_force = 0.0;
  for (const PairId id : scene.touching()) addForce(scene.result(id), sample);
}

void fillSample(const SceneOutline& outline, const SceneSnapshot& snapshot, PlotSample& sample) {
  fillFrom(
      snapshot, std::min(outline.pairs.size(), snapshot.pairs.size()),
      [&](std::size_t pair) { return pairClassOf(outline, outline.pairs[pair]); }, sample);
}

void fillSample(std::span<const PairClass> classes, const SceneSnapshot& snapshot, PlotSample& sample) {
  fillFrom(
      snapshot, std::min(classes.size(), snapshot.pairs.size()),
      [&](std::size_t pair) { return classes[pair]; }, sample);
}

}  // namespace abstand::view
