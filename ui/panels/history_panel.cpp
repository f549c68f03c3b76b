#include "ui/panels/history_panel.hpp"

namespace abstand::ui {

HistoryPanel::HistoryPanel(QUndoStack& steps, QWidget* parent) : QUndoView(&steps, parent) {
  setEmptyLabel(tr("As it was opened"));
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Edits of the project"));
  setToolTip(tr("A click goes back to the state after this edit, or forward to it"));
}

}  // namespace abstand::ui
