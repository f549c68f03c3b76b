// The scenes that were opened last.
#pragma once

#include <QStringList>

namespace abstand::ui {

inline constexpr int kRecentFiles = 5;

/// Newest first, from the user's settings.
QStringList recentFiles();
/// Moves `path` (made absolute) to the front and keeps kRecentFiles of them.
void rememberFile(const QString& path);

}  // namespace abstand::ui
