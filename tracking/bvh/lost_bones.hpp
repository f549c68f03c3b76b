// Bones that a conversion to BVH has lost.
#pragma once

#include <string>
#include <vector>

#include "tracking/bvh/bvh_hierarchy.hpp"

namespace abstand::tracking {

/// A bone that was put in between a joint and its children.
struct LostBone {
  std::string joint;   ///< where it begins
  double length{0.0};  ///< units of the file
  bool is_hand{false};
};

/// Captures of the CMU data base converted to BVH lack the ASF's `thorax` and wrist bones: neck and collars
/// begin where the thorax should begin, with OFFSET 0, and likewise the hand at the wrist.
///
/// A joint whose children all have OFFSET 0, two of them arms and a third one the neck, lacks a bone if the
/// spine from the hips up to it is shorter than 0.34 of a leg (CMU's ASF: 0.42, without thorax 0.28). An
/// OFFSET of at most 0.018 of a leg, some millimetres, counts as 0 and is kept behind the bone. The bone is
/// as long as the others of that spine in the median (ASF 11: 119 and 120 mm for 125 mm), along the last one.
/// Then a hand behind a wrist whose children all have OFFSET 0, shorter than half a forearm (usual: 0.74,
/// Drillis and Contini 1966, in Winter 2009, fig. 4.1), gets half a forearm as CMU's ASF have it. Changes the
/// OFFSETs of the children, and returns what was put in; empty: nothing is lost.
std::vector<LostBone> repairLostBones(BvhHierarchy& hierarchy);

}  // namespace abstand::tracking
