// Opens files by their kind.
#include "ui/file_commands.hpp"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QTimer>
#include <algorithm>

#include "ui/document/document.hpp"
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
  for (int i = 0; i < kRecentFiles; ++i) {
    QAction* action = recentAction(actions, i);
    connect(action, &QAction::triggered, this, [this, action] { open({action->data().toString()}); });
  }
}

void FileCommands::ask(const QString& title, const QString& filter) {
  open({QFileDialog::getOpenFileName(window_, title, recentFolder(), filter)});
}

void FileCommands::open(const QStringList& files) {
  for (const QString& file : files)
    if (!file.isEmpty()) openOne(file);
  showRecent();
}

void FileCommands::openOne(const QString& file) {
  const FileKind kind = kindOf(file);
  if (QFileInfo::exists(file)) {
    rememberFolder(file);
    if (kind != FileKind::kUnknown) rememberFile(file);
  }
  switch (kind) {
    case FileKind::kProject:
      return projects_.open(file);
    case FileKind::kScene:
      // The same scene is read anew, and the document stays.
      if (QFileInfo(file).absoluteFilePath() == document_.work().scene || projects_.mayDiscard())
        Q_EMIT sceneWanted(file);
      return;
    case FileKind::kRecording:
      Q_EMIT recordingWanted(file);
      return;
    case FileKind::kMargins:
      Q_EMIT marginsWanted(file);
      return;
    case FileKind::kMoments:
      if (projects_.mayDiscard()) Q_EMIT momentsWanted(file);
      return;
    case FileKind::kUnknown:
      Q_EMIT failed(tr("Cannot open"),
                    tr("%1 is no file that this program opens.\n\nIt opens projects (.abstand), scenes and "
                       "margins (.yaml), "
                       "robots (.urdf, .mech) and recordings: folders of depth images and the files %2.")
                        .arg(file, recordingEndings()));
  }
}

bool FileCommands::canOpen(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return std::any_of(urls.begin(), urls.end(),
                     [](const QUrl& url) { return kindOf(url.toLocalFile()) != FileKind::kUnknown; });
}

void FileCommands::openDropped(const QMimeData& data) {
  QStringList files;
  for (const FileKind kind :
       {FileKind::kProject, FileKind::kScene, FileKind::kRecording, FileKind::kMargins, FileKind::kMoments})
    for (const QUrl& url : data.urls())
      if (kindOf(url.toLocalFile()) == kind) files << url.toLocalFile();
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
