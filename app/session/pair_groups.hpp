// Groups of pairs that are started, paused and stopped together.
#pragma once

#include <string>
#include <vector>

#include "app/scene_file/scene_description.hpp"
#include "core/scene/scene.hpp"

namespace abstand::session {

struct PairGroup {
  std::string name;  ///< unique
  std::vector<PairId> pairs;
};

/// Assigns every pair of the scene to exactly one group. With `threads` from the scene file: its groups,
/// "group 1" and so on, and "rest" for pairs not listed. Without: one group for each combination of two
/// groups of bodies, "left_arm - operator". Remarks list the pairs in "rest" and named pairs that the scene
/// does not check.
std::vector<PairGroup> makePairGroups(const scene::Scene& scene, const scene_file::ThreadGroups& threads,
                                      std::vector<std::string>& remarks);

}  // namespace abstand::session
