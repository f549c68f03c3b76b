#include "ui/project_commands.hpp"

#include <QFileDialog>
#include <QMessageBox>

#include "ui/document/document.hpp"
#include "ui/document/project_file.hpp"
#include "ui/missing_files.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/style/file_kinds.hpp"

namespace abstand::ui {

ProjectCommands::ProjectCommands(Document& document, QWidget* window)
    : QObject(window), document_(document), window_(window) {}

bool ProjectCommands::mayDiscard() {
  const bool empty = document_.work().showsNothing();
  if (!dialogs_ || empty || !document_.modified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                  tr("The project has changes that are not saved. Save them?"),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setObjectName(QStringLiteral("unsaved_changes"));
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void ProjectCommands::open(const QString& file) {
  if (!mayDiscard()) return;
  try {
    Project project = readProject(file);
    const Project in_file = project;
    if (!findMissing(project, file)) return;
    Q_EMIT openWanted(project, QFileInfo(file).absoluteFilePath(), !(project == in_file));
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Cannot open the project"), QString::fromUtf8(e.what()));
  }
}

bool ProjectCommands::recover(Project project, const QString& file) {
  if (!findMissing(project, file)) return false;
  Q_EMIT openWanted(project, file, true);
  return true;
}

bool ProjectCommands::findMissing(Project& project, const QString& file) {
  if (dialogs_) return locateMissing(project, window_);
  const QString missing = missingFiles(project).value(0);
  if (!missing.isEmpty())
    Q_EMIT failed(tr("Cannot open the project"), tr("%1: names %2, which was not found").arg(file, missing));
  return missing.isEmpty();
}

bool ProjectCommands::save() { return document_.file().isEmpty() ? saveAs() : write(document_.file()); }

bool ProjectCommands::saveAs() {
  QFileDialog dialog(window_, tr("Save project"), recentFolder(), projectFilter());
  dialog.setObjectName(QStringLiteral("save_project"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QLatin1String(kProjectSuffix));
  const QString like = document_.file().isEmpty() ? document_.work().scene : document_.file();
  dialog.selectFile(QFileInfo(like).completeBaseName() + QLatin1Char('.') + QLatin1String(kProjectSuffix));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return false;
  const QString file = dialog.selectedFiles().constFirst();
  rememberFolder(file);
  return write(file);
}

bool ProjectCommands::write(const QString& file) {
  Q_EMIT aboutToSave();
  try {
    writeProject(document_.project(), file);
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Cannot save the project"), QString::fromUtf8(e.what()));
    return false;
  }
  document_.setSaved(QFileInfo(file).absoluteFilePath());
  Q_EMIT saved(file);
  return true;
}

}  // namespace abstand::ui
