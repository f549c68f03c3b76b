// Selects the pairs of a scene that are checked.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/scene_file/scene_description.hpp"

namespace abstand::scene_file {

/// A body with its attributes for the selection.
struct SelectableBody {
  std::string name;
  std::string group;
  bool person{false};  ///< part of a person; its group is the person
};

/// Pairs of indices (a < b) into `bodies`, in order, by the rules of the scene file. Later rules win: the
/// default, which omits pairs within one person unless `within_people` requests them (also under
/// `between_groups`); minus `adjacent` (from the mechanisms and the human), if the rules say so; minus the
/// pairs dropped by SRDFs and the file of pairs; minus exclude; plus include. Under `all`, pairs of objects
/// that never move relative to each other are included too; only an explicit exclude removes them. Throws
/// ParseError for an unknown name, with the nearest one, and for a body paired with itself.
std::vector<std::pair<int, int>> selectPairs(const std::vector<SelectableBody>& bodies,
                                             const PairsDescription& rules,
                                             const std::vector<std::pair<int, int>>& adjacent);

}  // namespace abstand::scene_file
