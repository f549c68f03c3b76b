#include "ui/model/recent_folder.hpp"

#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace abstand::ui {

namespace {
const QString kFolderKey = QStringLiteral("recent_folder");
}

QString recentFolder() {
  const QString folder = QSettings().value(kFolderKey).toString();
  if (!folder.isEmpty() && QFileInfo(folder).isDir()) return folder;
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void rememberFolder(const QString& path) { QSettings().setValue(kFolderKey, QFileInfo(path).absolutePath()); }

}  // namespace abstand::ui
