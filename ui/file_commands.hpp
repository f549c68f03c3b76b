// Opens files by their kind: menu, recent files, what is dropped on the window.
#pragma once

#include <QObject>
#include <QStringList>

#include "ui/model/file_batch.hpp"

class QMimeData;
class QWidget;

namespace abstand::ui {

class Actions;
class Document;
class ProjectCommands;

/// Projects it opens itself; what else a file is, somebody else opens. GUI thread only.
class FileCommands : public QObject {
  Q_OBJECT

 public:
  /// All outlive it; dialogs belong to `window`.
  FileCommands(const Actions& actions, const Document& document, ProjectCommands& projects, QWidget* window);

  /// Asks for the files by their kinds, all of them together, and remembers those that exist. Those that
  /// cannot be shown are named in failed(), one sentence each; the others are opened. An empty name is none.
  /// False: nothing is asked for.
  bool open(const QStringList& files);
  /// A session is shown: margins that were opened together with its scene are for it.
  void sessionShown();
  /// Later: whoever drops them waits for this event, and a question may take long.
  void openDropped(const QMimeData& data);
  /// One of its files is of a kind that can be opened.
  static bool canOpen(const QMimeData& data);
  /// The menu of recent files as it is now.
  void showRecent();

 Q_SIGNALS:
  void sceneWanted(const QString& file);
  void recordingWanted(const QString& file);
  void marginsWanted(const QString& file);
  void momentsWanted(const QString& file);
  void batchWanted(const abstand::ui::FileBatch& batch);
  void failed(const QString& title, const QString& problem);

 private:
  bool openOne(const QString& file);
  bool openTogether(const QStringList& files);
  void remember(const QString& file);
  void askFolder();
  void ask(const QString& title, const QString& filter);

  const Actions& actions_;
  const Document& document_;
  ProjectCommands& projects_;
  QWidget* window_;
  QString margins_later_;
};

}  // namespace abstand::ui
