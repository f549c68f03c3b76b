// Files that a project names and that are not where it says.
#pragma once

#include <QStringList>

#include "ui/document/work.hpp"

class QWidget;

namespace abstand::ui {

/// Files of a project that do not exist: scene, recording, added robots and meshes.
QStringList missingFiles(const Project& project);

/// Asks for each of them: the user says where it is, leaves a recording out, or gives up. False: given up.
bool locateMissing(Project& project, QWidget* parent);

}  // namespace abstand::ui
