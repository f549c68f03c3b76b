#include "ui/document/autosave.hpp"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUuid>

#include "core/base/output_file.hpp"
#include "ui/document/project_file.hpp"

namespace abstand::ui {

Autosave::Autosave(Document& document, const QString& folder, QObject* parent)
    : QObject(parent), document_(document) {
  QDir().mkpath(folder);
  const QString name = QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces));
  file_ = name + QLatin1Char('.') + QLatin1String(kProjectSuffix);
  lock_ = FileLock::tryLock(name + QStringLiteral(".lock"));
  connect(&timer_, &QTimer::timeout, this, &Autosave::write);
  timer_.start(kIntervalMs);
}

QString Autosave::standardFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/autosave");
}

void Autosave::write() {
  if (!timer_.isActive()) return;
  Q_EMIT aboutToWrite();
  const Work& work = document_.work();
  if (work.showsNothing()) return removeFile();
  std::string text = projectText(document_.project(), QString(), document_.file());
  if (text == written_) return;
  try {
    writeFile(QFile::encodeName(file_).toStdString(), text);
    written_ = std::move(text);
    failing_ = false;
  } catch (const std::exception& e) {
    if (!std::exchange(failing_, true)) Q_EMIT failed(QString::fromUtf8(e.what()));
  }
}

void Autosave::finish() {
  timer_.stop();
  removeFile();
  if (lock_) lock_->remove();
  lock_.reset();
}

void Autosave::removeFile() {
  if (!written_.empty()) QFile::remove(file_);
  written_.clear();
}

}  // namespace abstand::ui
