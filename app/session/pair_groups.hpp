// Groups of pairs that are run, paused and stopped together.
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

/// Every pair of the scene is in exactly one group. With `threads` from the scene file: its groups, "group 1"
/// and so on, and, where it leaves pairs out, the group "rest". Without: a group for each two groups of
/// bodies that have pairs, "left_arm - operator". Remarks say which pairs are in "rest" and which named pairs
/// the scene does not check.
std::vector<PairGroup> makePairGroups(const scene::Scene& scene, const scene_file::ThreadGroups& threads,
                                      std::vector<std::string>& remarks);

}  // namespace abstand::session
