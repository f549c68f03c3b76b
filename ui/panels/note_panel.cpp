// What a user should know of the scene before believing it: its reservations and remarks.
#include "ui/panels/note_panel.hpp"

#include <QHeaderView>

#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

QString weightText(scene::Severity severity) {
  switch (severity) {
    case scene::Severity::kAlways:
      return NotePanel::tr("⚠ fails check");
    case scene::Severity::kStrict:
      return NotePanel::tr("⚠ fails check --strict");
    case scene::Severity::kNote:
      break;
  }
  return NotePanel::tr("to know");
}

}  // namespace

NotePanel::NotePanel(QWidget* parent) : QTreeWidget(parent) {
  setAccessibleName(tr("Reservations"));
  setHeaderLabels({tr("Weight"), tr("Kind"), tr("Reason")});
  setRootIsDecorated(false);
  setAllColumnsShowFocus(true);
  setFrameShape(QFrame::NoFrame);
  header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setStretchLastSection(true);
}

void NotePanel::open(const std::vector<scene::SceneNote>& notes) {
  clear();
  doubts_ = 0;
  for (const scene::SceneNote& note : notes) {
    const QString text = QString::fromStdString(note.text);
    auto* row = new QTreeWidgetItem(this, {weightText(note.fails), QString::fromStdString(note.kind), text});
    // Long sentences do not fit into a panel.
    row->setToolTip(2, text);
    if (note.fails == scene::Severity::kAlways) row->setForeground(0, QColor(kVermillion));
    doubts_ += note.fails == scene::Severity::kNote ? 0 : 1;
  }
}

QString NotePanel::title() const {
  return doubts_ == 0 ? tr("Reservations") : tr("⚠ Reservations (%1)").arg(doubts_);
}

}  // namespace abstand::ui
