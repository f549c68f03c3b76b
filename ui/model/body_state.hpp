// How each body is shown: in the 3D view, the tree and their tips.
#pragma once

#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/pair_level.hpp"

namespace abstand::ui {

/// The worst of a body's pairs at one moment.
struct BodyState {
  PairLevel level{PairLevel::kUnknown};
  /// Of SceneOutline::pairs: the nearest of those of this level; -1: none.
  int pair{-1};
  Vector3d contact_force{Vector3d::Zero()};  ///< N: sum over the pairs that touch
  Vector3d virtual_force{Vector3d::Zero()};  ///< N: sum over the pairs that are only inside their margins
  /// "touching, 12.3 N" or "inside margin, virtual 12.3 N"; the force from `least` (N) on; empty elsewhere.
  QString words(double least) const;
};

/// Replaces `states` by those of all objects. Pairs that are not checked count for the level only where a
/// body has no other pair that is near, inside or touching.
void findBodyStates(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                    std::vector<BodyState>& states);

}  // namespace abstand::ui
