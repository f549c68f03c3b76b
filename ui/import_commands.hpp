// File > Import recording: asks for the file, how it is read, and where its joint map is kept.
#pragma once

#include <QObject>

#include "ui/model/import_probe.hpp"

class QWidget;

namespace abstand::ui {

class Actions;
class Document;

/// The recording and its reading become one edit of the document. GUI thread only.
class ImportCommands : public QObject {
  Q_OBJECT

 public:
  /// All outlive it; dialogs belong to `window`.
  ImportCommands(const Actions& actions, Document& document, QWidget* window);

  /// Without one nothing can be imported.
  void setReader(ImportReader reader);
  void open(const QString& file);

 Q_SIGNALS:
  void failed(const QString& title, const QString& problem);

 private:
  void ask();
  QString saveMap(const QString& file, const QString& text);

  const Actions& actions_;
  Document& document_;
  QWidget* window_;
  ImportReader reader_;
};

}  // namespace abstand::ui
