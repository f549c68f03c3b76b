// Says why bodies of a scene are no pair.
#pragma once

#include "app/scene_file/scene_description.hpp"
#include "core/view/snapshot.hpp"

namespace abstand::session {

/// Sets `unchecked` and `unchecked_notes` of an outline that has its objects and pairs: one entry for each
/// two bodies that selectPairs() left out, with the last rule that did.
/// @param adjacent  pairs of object indices, as for selectPairs()
void addUnchecked(const scene_file::PairsDescription& rules, const std::vector<std::pair<int, int>>& adjacent,
                  view::SceneOutline& outline);

}  // namespace abstand::session
