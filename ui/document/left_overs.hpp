// Autosaves of programs that did not end well.
#pragma once

#include <QDateTime>
#include <vector>

#include "ui/document/file_lock.hpp"
#include "ui/document/project_file.hpp"

namespace abstand::ui {

/// An autosave that nobody writes any more. No other program finds it as long as this one is there.
struct LeftOver {
  QString file;
  QDateTime written;
  ProjectFile content;
  QString problem;  ///< why the content could not be read; empty: it could
  FileLock lock;

  /// Its work was taken over or given up.
  void remove();
};

/// Those in a folder, the newest first. Removes what ended programs have left beside them.
std::vector<LeftOver> leftOvers(const QString& folder);

}  // namespace abstand::ui
