// The edits of the document, one below the other.
#pragma once

#include <QUndoView>

namespace abstand::ui {

/// A click on an edit takes back or makes again all edits in between. GUI thread only.
class HistoryPanel : public QUndoView {
  Q_OBJECT

 public:
  /// The stack outlives it.
  explicit HistoryPanel(QUndoStack& steps, QWidget* parent = nullptr);
};

}  // namespace abstand::ui
