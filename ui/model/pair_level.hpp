// How a pair is shown: in the table, and by the lines of the viewport.
#pragma once

#include <QColor>
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

/// Its colour in the 3D view, the tables, the lanes and the plots: vermillion where something touches, ochre
/// inside a margin, amber near it or with a pose that is lost, else grey.
QColor levelColour(PairLevel level);
/// Touching, or inside a margin.
inline bool isBroken(PairLevel level) { return level == PairLevel::kTouching || level == PairLevel::kInside; }

/// It is not certain that the bodies are apart where their poses put them. False without a result.
bool isTouching(const query::PairResult& result);

/// What the force of a pair is: of surfaces that touch, or only of the margins.
enum class ForceKind : std::uint8_t { kNone, kVirtual, kContact };
ForceKind forceKind(const query::PairResult& result);
/// "contact force 12.3 N", "virtual (margin) force 12.3 N", "no force".
QString forceText(ForceKind kind, double newtons);

/// m, of both bodies' poses.
double poseUncertainty(const view::SceneSnapshot& snapshot, std::pair<int, int> objects);

}  // namespace abstand::ui
