#include "ui/missing_files.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "ui/model/recent_folder.hpp"

namespace abstand::ui {

namespace {

enum class Answer { kLocated, kSkipped, kGivenUp };

bool isMissing(const QString& file) { return !file.isEmpty() && !QFileInfo::exists(file); }

QString text(const char* words) { return QCoreApplication::translate("missing_files", words); }

/// Where the user says that `file` is; it stays as it is where they choose none.
QString chosenFile(const QString& file, QWidget* parent) {
  const QString folder = QFileInfo(file).absolutePath();
  QFileDialog dialog(parent, text(QT_TRANSLATE_NOOP("missing_files", "Locate %1")).arg(file),
                     QDir(folder).exists() ? folder : recentFolder());
  dialog.setObjectName(QStringLiteral("locate_file"));
  // A depth recording is a folder.
  dialog.setFileMode(QFileInfo(file).suffix().isEmpty() ? QFileDialog::Directory : QFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return file;
  rememberFolder(dialog.selectedFiles().constFirst());
  return dialog.selectedFiles().constFirst();
}

/// Asks until the file exists.
/// @param skip_word  of the button that does without the file; empty: there is none
Answer locate(QString& file, const QString& question, const QString& skip_word, QWidget* parent) {
  while (isMissing(file)) {
    QMessageBox box(QMessageBox::Warning, text(QT_TRANSLATE_NOOP("missing_files", "Missing file")),
                    question.arg(file), QMessageBox::Cancel, parent);
    box.setObjectName(QStringLiteral("missing_file"));
    box.setTextFormat(Qt::PlainText);
    QPushButton* find =
        box.addButton(text(QT_TRANSLATE_NOOP("missing_files", "&Locate…")), QMessageBox::AcceptRole);
    QPushButton* skip =
        skip_word.isEmpty() ? nullptr : box.addButton(skip_word, QMessageBox::DestructiveRole);
    box.setDefaultButton(find);
    box.exec();
    if (skip && box.clickedButton() == skip) return Answer::kSkipped;
    if (box.clickedButton() != find) return Answer::kGivenUp;
    file = chosenFile(file, parent);
  }
  return Answer::kLocated;
}

}  // namespace

QStringList missingFiles(const Project& project) {
  QStringList missing;
  for (const QString& file :
       QStringList{project.work.scene, project.work.recording} + project.work.added_files)
    if (isMissing(file)) missing << file;
  return missing;
}

bool locateMissing(Project& project, QWidget* parent) {
  Work& work = project.work;
  if (locate(work.scene,
             text(QT_TRANSLATE_NOOP("missing_files", "The scene of the project was not found:\n%1")), {},
             parent) == Answer::kGivenUp)
    return false;
  const QString scenes_own = text(QT_TRANSLATE_NOOP("missing_files", "&Use the scene's recording"));
  const Answer answer =
      locate(work.recording,
             text(QT_TRANSLATE_NOOP("missing_files", "The recording of the project was not found:\n%1")),
             work.scene.isEmpty() ? QString() : scenes_own, parent);
  if (answer == Answer::kGivenUp) return false;
  if (answer == Answer::kSkipped) work.recording.clear();
  QStringList found;
  for (QString file : work.added_files) {
    const Answer of_file = locate(
        file, text(QT_TRANSLATE_NOOP("missing_files", "A file that the project adds was not found:\n%1")),
        text(QT_TRANSLATE_NOOP("missing_files", "&Do without it")), parent);
    if (of_file == Answer::kGivenUp) return false;
    if (of_file == Answer::kLocated) found << file;
  }
  work.added_files = found;
  return true;
}

}  // namespace abstand::ui
