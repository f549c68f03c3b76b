// Opens files by their kind: menu, recent files, what is dropped on the window.
#pragma once

#include <QObject>
#include <QStringList>

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

  /// Asks for the files by their kinds, in this order, and remembers those that exist. An empty name is none.
  void open(const QStringList& files);
  /// A scene before the recordings that shall run in it. Later: whoever drops them waits for this event, and
  /// a question may take long.
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
  void failed(const QString& title, const QString& problem);

 private:
  void openOne(const QString& file);
  void ask(const QString& title, const QString& filter);

  const Actions& actions_;
  const Document& document_;
  ProjectCommands& projects_;
  QWidget* window_;
};

}  // namespace abstand::ui
