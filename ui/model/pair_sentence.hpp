// What a colour means, in a full sentence.
#pragma once

#include <QString>

#include "ui/model/body_state.hpp"
#include "ui/model/level_times.hpp"

namespace abstand::ui {

/// Of a pair whose two poses together are known within `pose_uncertainty` (m): "32.1 mm", "331 mm ± 529 mm",
/// "331 mm, pose unknown".
QString distanceText(double distance, double pose_uncertainty);

/// "arm/link4 and operator/hand_left are inside the margin since 1.240 s: distance 32.1 mm ± 1.5 mm, margin
/// 50 mm, closing at 0.52 m/s, virtual (margin) force 44.8 N." Empty where the snapshot is of another scene.
QString pairSentence(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int pair,
                     const LevelTimes::Since& since);

/// Lines: the body's name, the sentence of its worst pair, and one on a pose that is lost.
QString bodySentence(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int object,
                     const LevelTimes& times);

}  // namespace abstand::ui
