// The scenes that were opened last.
#include "ui/model/recent_files.hpp"

#include <QFileInfo>
#include <QSettings>

namespace abstand::ui {

namespace {
const QString kKey = QStringLiteral("recent_scenes");
}

QStringList recentFiles() { return QSettings().value(kKey).toStringList().mid(0, kRecentFiles); }

void rememberFile(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList files = recentFiles();
  files.removeAll(absolute);
  files.prepend(absolute);
  QSettings().setValue(kKey, QStringList(files.mid(0, kRecentFiles)));
}

}  // namespace abstand::ui
