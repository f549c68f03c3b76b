// Opens files by their kind.
#include "ui/file_commands.hpp"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "ui/document/document.hpp"
#include "ui/model/file_batch.hpp"
#include "ui/model/recent_files.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/project_commands.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/file_kinds.hpp"

namespace abstand::ui {

namespace {
QAction* recentAction(const Actions& actions, int i) {
  return actions[static_cast<ActionId>(static_cast<int>(ActionId::kRecent1) + i)];
}
}  // namespace

FileCommands::FileCommands(const Actions& actions, const Document& document, ProjectCommands& projects,
                           QWidget* window)
    : QObject(window), actions_{actions}, document_{document}, projects_{projects}, window_{window} {
  connect(actions[ActionId::kOpenScene], &QAction::triggered, this,
          [this] { ask(tr("Open"), openFilter()); });
  connect(actions[ActionId::kOpenRecording], &QAction::triggered, this,
          [this] { ask(tr("Open recording"), recordingFilter()); });
  connect(actions[ActionId::kOpenDepthFolder], &QAction::triggered, this, &FileCommands::askFolder);
  for (int i = 0; i < kRecentFiles; ++i) {
    QAction* action = recentAction(actions, i);
    connect(action, &QAction::triggered, this, [this, action] { open({action->data().toString()}); });
  }
}

void FileCommands::ask(const QString& title, const QString& filter) {
  QFileDialog dialog(window_, title, recentFolder(), filter);
  dialog.setObjectName(QStringLiteral("open_files"));
  dialog.setFileMode(QFileDialog::ExistingFiles);
  if (dialog.exec() == QDialog::Accepted) open(dialog.selectedFiles());
}

void FileCommands::askFolder() {
  QFileDialog dialog(window_, tr("Open depth images"), recentFolder());
  dialog.setObjectName(QStringLiteral("open_depth_folder"));
  dialog.setFileMode(QFileDialog::Directory);
  dialog.setOption(QFileDialog::ShowDirsOnly);
  if (dialog.exec() == QDialog::Accepted) open(dialog.selectedFiles());
}

bool FileCommands::open(const QStringList& files) {
  margins_later_.clear();
  bool asked = true;
  if (files.size() == 1 && !files.constFirst().isEmpty())
    asked = openOne(files.constFirst());
  else
    asked = openTogether(files);
  showRecent();
  return asked;
}

void FileCommands::remember(const QString& file) {
  if (!QFileInfo::exists(file)) return;
  rememberFolder(file);
  if (kindOf(file) != FileKind::kUnknown) rememberFile(file);
}

bool FileCommands::openOne(const QString& file) {
  remember(file);
  const Work& work = document_.work();
  switch (kindOf(file)) {
    case FileKind::kProject:
      projects_.open(file);
      return true;
    case FileKind::kRobot:
      // A robot for the person or the things that are there already.
      if (work.scene.isEmpty() && !work.showsNothing()) {
        Q_EMIT batchWanted({file, {}, {}, false});
        return true;
      }
      [[fallthrough]];
    case FileKind::kScene:
      // The same scene is read anew, and the document stays.
      if (QFileInfo(file).absoluteFilePath() == work.scene || projects_.mayDiscard())
        Q_EMIT sceneWanted(file);
      return true;
    case FileKind::kMesh:
      Q_EMIT batchWanted({{}, {file}, {}, false});
      return true;
    case FileKind::kRecording:
      Q_EMIT recordingWanted(file);
      return true;
    case FileKind::kMargins:
      Q_EMIT marginsWanted(file);
      return true;
    case FileKind::kMoments:
      if (projects_.mayDiscard()) Q_EMIT momentsWanted(file);
      return true;
    case FileKind::kUnknown:
      break;
  }
  Q_EMIT failed(tr("Cannot open"), whyNotOpened(file));
  return false;
}

/// Robots among the files begin a new scene; meshes and a recording alone are added to what is shown.
bool FileCommands::openTogether(const QStringList& files) {
  const bool any_robot = std::any_of(files.begin(), files.end(),
                                     [](const QString& file) { return kindOf(file) == FileKind::kRobot; });
  const Work& work = document_.work();
  const bool added_to = !work.scene.isEmpty() && !any_robot;
  SortedFiles sorted = sortedFiles(files, added_to);
  sorted.batch.fresh |= !work.scene.isEmpty() && !sorted.batch.scene.isEmpty();
  for (const QString& file : files) remember(file);
  if (!sorted.problems.isEmpty()) Q_EMIT failed(tr("Not opened"), sorted.problems.join(QLatin1Char('\n')));
  if (sorted.empty()) return false;
  if (!sorted.project.isEmpty()) projects_.open(sorted.project);
  if (!sorted.moments.isEmpty() && projects_.mayDiscard()) Q_EMIT momentsWanted(sorted.moments);
  const FileBatch& batch = sorted.batch;
  if (batch.fresh && !projects_.mayDiscard()) return true;
  if (batch.empty() && sorted.project.isEmpty() && sorted.moments.isEmpty()) {
    Q_EMIT marginsWanted(sorted.margins);
    return true;
  }
  margins_later_ = sorted.margins;
  if (!batch.empty()) Q_EMIT batchWanted(batch);
  return true;
}

void FileCommands::sessionShown() {
  const QString margins = std::exchange(margins_later_, QString());
  if (!margins.isEmpty()) Q_EMIT marginsWanted(margins);
}

bool FileCommands::canOpen(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return std::any_of(urls.begin(), urls.end(),
                     [](const QUrl& url) { return kindOf(url.toLocalFile()) != FileKind::kUnknown; });
}

void FileCommands::openDropped(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls()) files << (url.isLocalFile() ? url.toLocalFile() : url.toString());
  QTimer::singleShot(0, this, [this, files] { open(files); });
}

void FileCommands::showRecent() {
  QStringList files;
  for (const QString& file : recentFiles())
    if (QFileInfo::exists(file)) files << file;
  for (int i = 0; i < kRecentFiles; ++i) {
    QAction* action = recentAction(actions_, i);
    action->setVisible(i < files.size());
    if (i >= files.size()) continue;
    action->setData(files[i]);
    // Files of the same name differ by their folders.
    const QFileInfo info(files[i]);
    action->setText(tr("%1  (%2)")
                        .arg(info.fileName(), QDir::toNativeSeparators(info.absolutePath()))
                        .replace(QLatin1Char('&'), QLatin1String("&&")));
    action->setStatusTip(files[i]);
  }
}

}  // namespace abstand::ui
