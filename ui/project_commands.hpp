// New, open and save of project files, with the questions that belong to them.
#pragma once

#include <QObject>

#include "ui/document/work.hpp"

class QWidget;

namespace abstand::ui {

class Document;

/// Works on the window's document. Dialogs belong to `window`. GUI thread only.
class ProjectCommands : public QObject {
  Q_OBJECT

 public:
  ProjectCommands(Document& document, QWidget* window);

  /// Without dialogs: what would be asked for is an error instead. At first: with.
  void setDialogs(bool on) { dialogs_ = on; }
  /// Asks what shall become of work that is not saved. False: the user wants to stay.
  bool mayDiscard();
  /// Reads the file, asks for files that it names and that are missing, and asks to open it.
  void open(const QString& file);
  /// Takes over a project that was not saved. False: the user did not say where a missing file is.
  bool recover(Project project, const QString& file);
  /// False where it was not written.
  bool save();
  bool saveAs();

 Q_SIGNALS:
  /// Before the document is written: its viewpoint shall be that of the window.
  void aboutToSave();
  /// `modified`: `project` is not what `file` holds.
  void openWanted(const abstand::ui::Project& project, const QString& file, bool modified);
  void saved(const QString& file);
  void failed(const QString& title, const QString& problem);

 private:
  bool write(const QString& file);
  bool findMissing(Project& project, const QString& file);

  Document& document_;
  QWidget* window_;
  bool dialogs_{true};
};

}  // namespace abstand::ui
