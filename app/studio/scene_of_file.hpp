// Scenes of files that are none by themselves.
#pragma once

#include <QString>

#include "app/scene_file/scene_description.hpp"

namespace abstand::studio {

/// A scene file as it says; of a robot file (.urdf, .mech) a scene with that robot alone; of an empty name a
/// scene with one person who moves as in `recording`. Throws ParseError and UsageError.
scene_file::SceneDescription sceneOf(const QString& file, const QString& recording,
                                     const robot_file::PackagePaths& packages);

}  // namespace abstand::studio
