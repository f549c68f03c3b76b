// The plotted figures of one snapshot.
#pragma once

#include "core/view/snapshot.hpp"

namespace abstand::ui {

/// As the loop makes them in every cycle (PlotSample), from what the window shows. `joint`: whose torques,
/// index of SceneOutline::joints; -1: the largest of all joints.
view::PlotSample momentSample(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                              int joint);

}  // namespace abstand::ui
