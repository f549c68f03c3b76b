// Keeps a copy of the document on disk while the program runs.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>
#include <string>
#include <utility>

#include "ui/document/document.hpp"
#include "ui/document/file_lock.hpp"

namespace abstand::ui {

/// Writes the document soon after a change, whole or not at all, into a file of its own. Where the program is
/// killed the file stays, and leftOvers() finds it. GUI thread only.
class Autosave : public QObject {
  Q_OBJECT

 public:
  /// Between two looks at the document.
  static constexpr int kIntervalMs = 2000;

  /// `folder` is made where it does not exist.
  Autosave(Document& document, const QString& folder, QObject* parent = nullptr);

  /// Folder of the user's autosaves.
  static QString standardFolder();
  const QString& file() const { return file_; }
  /// Writes what has changed since the last time; removes the file while the document has no scene.
  void write();
  /// The work is saved or given up: removes the file. Nothing is written from then on.
  void finish();

 Q_SIGNALS:
  /// Before a look: the owner may bring the document's viewpoint up to date.
  void aboutToWrite();
  /// Once for a row of failures.
  void failed(const QString& problem);

 private:
  void removeFile();

  Document& document_;
  QString file_;
  std::optional<FileLock> lock_;
  std::string written_;  // content of the file; empty: none
  bool failing_{false};
  QTimer timer_;
};

}  // namespace abstand::ui
