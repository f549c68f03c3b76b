// What the inspector says of a robot's motion and joints.
#pragma once

#include <QString>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/inspected_rows.hpp"

namespace abstand::ui {

/// "posed by hand", "protective stop", "follows joints.csv", "rests". `robot`: index into
/// SceneOutline::robots.
QString robotMotionText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot, int robot);

/// A row for each joint: value, limits, torques.
std::vector<InspectedRow> jointRows(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                                    int robot);

/// A joint's value with its unit: rad as degrees, m as millimetres.
QString jointValueText(const view::SceneOutline::JointInfo& joint, double value);

}  // namespace abstand::ui
