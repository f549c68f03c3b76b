// Files of a batch that keep the others from being shown.
#pragma once

#include <QStringList>

#include "core/robot_file/mesh_reference.hpp"
#include "ui/document/work.hpp"

namespace abstand::studio {

/// Takes from `work` every file that cannot be read by itself: scene, robots, meshes and the recording.
/// Returns a sentence for each, with the file and the reason.
QStringList leaveOutUnreadable(ui::Work& work, const robot_file::PackagePaths& packages);

}  // namespace abstand::studio
