// Where the user was last with a file dialog.
#pragma once

#include <QString>

namespace abstand::ui {

/// From the user's settings; the documents folder at first.
QString recentFolder();
/// That of a file or folder.
void rememberFolder(const QString& path);

}  // namespace abstand::ui
