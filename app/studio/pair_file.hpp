// Pairs of a robot's links that are not checked, as SRDF.
#pragma once

#include <string>

#include "core/robot_file/srdf_file.hpp"
#include "core/view/snapshot.hpp"
#include "ui/document/work.hpp"

namespace abstand::studio {

/// Pairs of links of one robot that the scene leaves out or the user has taken out of their group, by the
/// names of the links without the robot's. Reasons: "Adjacent"; "User" for what the user has taken out; else
/// "Default".
robot_file::Srdf uncheckedPairs(const view::SceneOutline& outline, const ui::Work& work,
                                const std::string& robot);

/// Takes every pair that `srdf` disables and the scene checks out of its group. The number of pairs; 0: none
/// of the robot's links is named.
std::size_t disablePairs(const robot_file::Srdf& srdf, const view::SceneOutline& outline,
                         const std::string& robot, ui::Work& work);

}  // namespace abstand::studio
