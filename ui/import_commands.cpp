// File > Import recording.
#include "ui/import_commands.hpp"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

#include "core/base/output_file.hpp"
#include "ui/document/document.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/panels/import_dialog.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/file_kinds.hpp"

namespace abstand::ui {

ImportCommands::ImportCommands(const Actions& actions, Document& document, QWidget* window)
    : QObject(window), actions_{actions}, document_{document}, window_{window} {
  connect(actions[ActionId::kImport], &QAction::triggered, this, &ImportCommands::ask);
  actions[ActionId::kImport]->setEnabled(false);
}

void ImportCommands::setReader(ImportReader reader) {
  reader_ = std::move(reader);
  actions_[ActionId::kImport]->setEnabled(static_cast<bool>(reader_));
}

void ImportCommands::ask() {
  const QString file =
      QFileDialog::getOpenFileName(window_, tr("Import recording"), recentFolder(), recordingFilter());
  if (!file.isEmpty()) open(file);
}

void ImportCommands::open(const QString& file) {
  rememberFolder(file);
  ImportDialog dialog(file, reader_, window_);
  if (dialog.exec() != QDialog::Accepted) return;
  ReadingOptions reading = document_.work().reading;
  reading.units = dialog.wish().units;
  reading.up = dialog.wish().up;
  reading.mirror = dialog.wish().mirror;
  reading.joint_map.clear();
  if (dialog.hasOwnJoints()) {
    reading.joint_map = saveMap(file, dialog.found().map_text);
    if (reading.joint_map.isEmpty()) return;
  }
  document_.edit(tr("import recording %1").arg(QFileInfo(file).fileName()), [&](Work& work) {
    work.recording = QFileInfo(file).absoluteFilePath();
    work.reading = reading;
  });
}

/// Empty: the user does not want to, or it failed.
QString ImportCommands::saveMap(const QString& file, const QString& text) {
  QFileDialog dialog(window_, tr("Save joint map"), QFileInfo(file).absolutePath(), tr("Joint maps (*.map)"));
  dialog.setObjectName(QStringLiteral("save_joint_map"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("map"));
  dialog.selectFile(QFileInfo(file).completeBaseName() + QStringLiteral(".map"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
  const QString map = QFileInfo(dialog.selectedFiles().constFirst()).absoluteFilePath();
  try {
    writeFile(QFile::encodeName(map).toStdString(), text.toStdString());
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Save joint map"), QString::fromUtf8(e.what()));
    return {};
  }
  return map;
}

}  // namespace abstand::ui
