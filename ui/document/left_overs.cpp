#include "ui/document/left_overs.hpp"

#include <QDir>
#include <QFile>

#include "core/base/text_file.hpp"
#include "core/config/yaml_document.hpp"

namespace abstand::ui {

void LeftOver::remove() {
  QFile::remove(file);
  lock.remove();
}

namespace {

/// Lock files without an autosave, and half-written files.
void removeRubbish(const QDir& folder) {
  for (const QFileInfo& info : folder.entryInfoList({QStringLiteral("*.lock")}, QDir::Files)) {
    const QString name = info.completeBaseName();
    auto lock = FileLock::tryLock(info.absoluteFilePath());
    if (!lock) continue;
    const QString autosave = name + QLatin1Char('.') + QLatin1String(kProjectSuffix);
    for (const QString& file : folder.entryList({name + QStringLiteral("*")}, QDir::Files | QDir::Hidden))
      if (file != autosave && file != info.fileName()) QFile::remove(folder.filePath(file));
    if (!folder.exists(autosave)) lock->remove();
  }
}

}  // namespace

std::vector<LeftOver> leftOvers(const QString& folder) {
  removeRubbish(QDir(folder));
  std::vector<LeftOver> found;
  const QString pattern = QStringLiteral("*.") + QLatin1String(kProjectSuffix);
  const QFileInfoList files = QDir(folder).entryInfoList({pattern}, QDir::Files, QDir::Time);
  for (const QFileInfo& info : files) {
    auto lock = FileLock::tryLock(info.absolutePath() + QLatin1Char('/') + info.completeBaseName() +
                                  QStringLiteral(".lock"));
    if (!lock) continue;
    LeftOver left{info.absoluteFilePath(), info.lastModified(), {}, {}, std::move(*lock)};
    try {
      const std::string text = readFile(QFile::encodeName(left.file).toStdString(), config::kMaxYamlBytes);
      left.content = parseProject(text, left.file, folder);
    } catch (const std::exception& e) {
      left.problem = QString::fromUtf8(e.what());
    }
    found.push_back(std::move(left));
  }
  return found;
}

}  // namespace abstand::ui
