// The document of the window: what the user made, with undo.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>

#include "ui/document/work.hpp"

namespace abstand::ui {

/// Panels edit it; session, viewport and panels follow its signals. GUI thread only.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);

  const Work& work() const { return work_; }
  const Viewpoint& viewpoint() const { return viewpoint_; }
  Project project() const { return {work_, viewpoint_}; }
  /// Absolute path of the project file; empty: never saved.
  const QString& file() const { return file_; }
  /// The work differs from the project file.
  bool modified() const { return !steps_.isClean(); }
  /// One step an edit. The Edit menu shows its texts.
  QUndoStack& steps() { return steps_; }

  /// One undo step named `text`; none where `change` changes nothing. Edits with the same `merge_key` that
  /// follow each other are one step, until endStep().
  void edit(const QString& text, const std::function<void(Work&)>& change, const QString& merge_key = {});
  /// The next edit is a step of its own.
  void endStep() { ++gesture_; }
  /// No undo step, and no modification.
  void setViewpoint(const Viewpoint& viewpoint) { viewpoint_ = viewpoint; }

  /// Replaces everything; nothing can be undone afterwards. `modified`: `project` is not what `file` holds.
  void open(const Project& project, const QString& file, bool modified);
  /// The work was written to `file`.
  void setSaved(const QString& file);

 Q_SIGNALS:
  /// By an edit, an undo or a redo.
  void workChanged(const abstand::ui::Work& before, const abstand::ui::Work& after);
  /// open() has replaced everything.
  void opened();
  /// The file's name or modified() may have changed.
  void titleChanged();

 private:
  class Step;
  void take(const Work& work);

  Work work_;
  Viewpoint viewpoint_;
  QString file_;
  QUndoStack steps_;
  long gesture_{0};
};

}  // namespace abstand::ui
