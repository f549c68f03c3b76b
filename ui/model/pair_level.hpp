// How a pair is shown: in the table, and by the lines of the viewport.
#pragma once

#include <QString>

#include "core/view/snapshot.hpp"

namespace abstand::ui {

/// In the order of their weight; unknown and inside are never shown as safe.
enum class PairLevel : std::uint8_t {
  kUnknown,  ///< no result yet
  kApart,
  kNear,    ///< certified clearance below kNearFactor times the margin
  kLost,    ///< a pose is stale or was rejected
  kPaused,  ///< not checked
  /// The margin is broken (shell points are within it), or it is not proven that it is kept: what `check`
  /// would not pass.
  kInside,
  kTouching,  ///< distance within its error bound, or penetration
};

/// @param pair     of the snapshot
/// @param objects  numbers of its two objects
PairLevel pairLevel(const view::SceneSnapshot& snapshot, const view::PairSnapshot& pair,
                    std::pair<int, int> objects);

/// The word for it, with its mark: "⚠ touching", "clear"; a dash without a result.
QString levelText(PairLevel level);

/// It is not certain that the bodies are apart where their poses put them. False without a result.
bool isTouching(const query::PairResult& result);

/// m, of both bodies' poses.
double poseUncertainty(const view::SceneSnapshot& snapshot, std::pair<int, int> objects);

}  // namespace abstand::ui
