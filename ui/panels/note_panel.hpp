// What a user should know of the scene before believing it: its reservations and remarks.
#pragma once

#include <QTreeWidget>
#include <vector>

#include "core/scene/scene_note.hpp"

namespace abstand::ui {

/// A row for each note: what it does to `abstand check`, its kind, its text. GUI thread only.
class NotePanel : public QTreeWidget {
  Q_OBJECT

 public:
  explicit NotePanel(QWidget* parent = nullptr);

  void open(const std::vector<scene::SceneNote>& notes);
  /// "⚠ Reservations (2)": those that may fail a check; "Reservations" without.
  QString title() const;

 private:
  int doubts_{0};  ///< notes that fail a check
};

}  // namespace abstand::ui
