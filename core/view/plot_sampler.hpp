// Distances and forces of one cycle for the plots.
#pragma once

#include <span>

#include "core/scene/minimum_tree.hpp"
#include "core/view/snapshot.hpp"

namespace abstand::view {

/// Fills the distances and forces of a PlotSample after each step of a scene: min_distance, nearest_pair,
/// class_distance, contact_force and virtual_force. Paused pairs count in none of them. Only pairs that the
/// last step updated are visited, as long as no step is left out. Does not allocate. One thread.
class PlotSampler {
 public:
  /// `outline`: of the scene.
  explicit PlotSampler(const SceneOutline& outline);
  void fill(const scene::Scene& scene, PlotSample& sample);

 private:
  void take(const scene::Scene& scene, std::size_t pair);

  std::vector<PairClass> classes_;                          ///< by pair
  std::vector<std::size_t> places_;                         ///< by pair: its place among those of its class
  std::array<scene::MinimumTree, kPairClasses> distances_;  ///< m
  long steps_{-1};                                          ///< Scene::steps() at the last fill()
};

/// The same from a snapshot.
void fillSample(const SceneOutline& outline, const SceneSnapshot& snapshot, PlotSample& sample);
/// `classes`: of each pair of the snapshot.
void fillSample(std::span<const PairClass> classes, const SceneSnapshot& snapshot, PlotSample& sample);

}  // namespace abstand::view
