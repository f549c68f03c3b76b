// Which pairs of a scene are checked.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/scene_file/scene_description.hpp"

namespace abstand::scene_file {

/// One body as the selection sees it.
struct SelectableBody {
  std::string name;
  std::string group;
  bool person{false};  ///< a part of one; its group is the person
};

/// Indices (a < b) into `bodies`, in order, by the rules of the scene file. Later rules win: the default,
/// which leaves out the parts of one person against each other unless `within_people` asks for them, as it
/// does under `between_groups` too;
/// minus `adjacent` (given by the mechanisms and the human), when the rules say so; minus what SRDFs and the
/// file of pairs drop; minus exclude; plus include. Under `all`, pairs of things that never move against each
/// other are checked too: an explicit exclude takes them out. Throws ParseError for a name that is not there,
/// with the nearest one, and for a body paired with itself.
std::vector<std::pair<int, int>> selectPairs(const std::vector<SelectableBody>& bodies,
                                             const PairsDescription& rules,
                                             const std::vector<std::pair<int, int>>& adjacent);

}  // namespace abstand::scene_file
