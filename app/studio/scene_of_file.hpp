// Scenes of files that are none by themselves.
#pragma once

#include "app/scene_file/scene_description.hpp"
#include "ui/document/work.hpp"

namespace abstand::studio {

/// m. A mesh with a larger extent is taken to be in millimetres.
inline constexpr double kLargestThing = 50.0;

/// What is to be loaded, without the reading options and the people of applyWork(). A scene file as it says;
/// of a robot file (.urdf, .mech) a scene with that robot; of an empty name an empty scene. Where these have
/// no people of their own, a recording brings one person. The robots and meshes of `added_files` follow, each
/// under a name of its own; meshes are read for their size. Throws ParseError and UsageError.
scene_file::SceneDescription sceneOf(const ui::Work& work, const robot_file::PackagePaths& packages);

/// The scene of `work` is a scene file, not a robot.
bool hasSceneFile(const ui::Work& work);

/// In the quotes of YAML.
std::string quoted(const QString& text);

/// `work` is more than a scene file with a recording.
bool isComposed(const ui::Work& work);

}  // namespace abstand::studio
