// How a pair is shown: in the table, and by the lines of the viewport.
#pragma once

#include "core/view/snapshot.hpp"

namespace abstand::ui {

/// In the order of their weight; unknown and inside are never shown as safe.
enum class PairLevel : std::uint8_t {
  kUnknown,  ///< no result yet
  kApart,
  kNear,     ///< certified clearance below kNearFactor times the margin
  kLost,     ///< a pose is stale or was rejected
  kPaused,   ///< not checked
  kInside,   ///< the margin is broken, or that it is kept is not proven: what `check` would not pass
  kContact,  ///< shell points within the margin, or penetration
};

/// @param pair     of the snapshot
/// @param objects  numbers of its two objects
PairLevel pairLevel(const view::SceneSnapshot& snapshot, const view::PairSnapshot& pair,
                    std::pair<int, int> objects);

/// m, of both bodies' poses.
double poseUncertainty(const view::SceneSnapshot& snapshot, std::pair<int, int> objects);

}  // namespace abstand::ui
