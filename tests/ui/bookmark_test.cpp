// Bookmarks by keys: added, visited with their camera, removed, undone.
#include <QAction>
#include <QDockWidget>
#include <QInputDialog>
#include <QPushButton>
#include <QStatusBar>
#include <QTableView>

#include "tests/ui/modal_answer.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/document/document.hpp"
#include "ui/model/playback.hpp"
#include "ui/panels/bookmark_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {
namespace bookmark_test {

struct BookmarkTest : ShownWindow {
  void add(double t, const QString& note) {
    window.playback().seek(t);
    const ModalAnswer answer("bookmark_note", [note](QWidget* dialog) {
      auto* input = static_cast<QInputDialog*>(dialog);
      input->setTextValue(note);
      input->accept();
    });
    window.actions()[ActionId::kAddBookmark]->trigger();
    EXPECT_TRUE(answer.answered());
  }
  void key(int k, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, static_cast<Qt::Key>(k), modifiers);
  }
  const QVector<Bookmark>& marks() const { return window.document().work().bookmarks; }
};

TEST_F(BookmarkTest, VisitRestoresCameraAndNote) {
  window.actions()[ActionId::kTop]->trigger();
  const CameraView top = window.viewport().cameraView();
  add(5.0, "  the hand\nis near ");
  window.actions()[ActionId::kFront]->trigger();
  add(2.0, "");
  ASSERT_EQ(marks().size(), 2);
  EXPECT_EQ(marks()[0].t, 2.0);
  EXPECT_EQ(marks()[1].note, "the hand is near") << "one line";
  window.playback().seek(0.0);
  key(Qt::Key_B);
  EXPECT_NEAR(session.time(), 2.0, 1e-9);
  key(Qt::Key_B);
  EXPECT_NEAR(session.time(), 5.0, 1e-9);
  EXPECT_EQ(window.viewport().cameraView(), top);
  EXPECT_TRUE(window.statusBar()->currentMessage().contains("the hand is near"));
  key(Qt::Key_B);
  EXPECT_NEAR(session.time(), 5.0, 1e-9) << "there is no later one";
  key(Qt::Key_B, Qt::ShiftModifier);
  EXPECT_NEAR(session.time(), 2.0, 1e-9);
}

TEST_F(BookmarkTest, OnePerFrameIsKeptRemovedAndUndone) {
  add(3.0, "first");
  add(3.0, "second");
  ASSERT_EQ(marks().size(), 1);
  EXPECT_EQ(marks()[0].note, "second");
  window.actions()[ActionId::kRemoveBookmark]->trigger();
  EXPECT_TRUE(marks().isEmpty());
  window.actions()[ActionId::kUndo]->trigger();
  EXPECT_EQ(marks().size(), 1);
  while (window.actions()[ActionId::kUndo]->isEnabled()) window.actions()[ActionId::kUndo]->trigger();
  EXPECT_TRUE(marks().isEmpty());
}

TEST_F(BookmarkTest, PanelListsEditsAndRemoves) {
  window.document().edit("bookmarks", [](Work& work) {
    work.bookmarks = {{3.0, "near", {}}, {6.0, "far", {}}};
  });
  auto* dock = window.findChild<QDockWidget*>("bookmarks");
  ASSERT_TRUE(dock);
  dock->raise();
  QTableView* table = window.panels().bookmarks->table();
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->isVisible(); }, 60000));
  QAbstractItemModel& rows = *table->model();
  ASSERT_EQ(rows.rowCount(), 2);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(rows.index(0, 0)).center());
  EXPECT_EQ(session.time(), 3.0);
  EXPECT_TRUE(rows.setData(rows.index(1, 1), "very\nfar", Qt::EditRole));
  EXPECT_EQ(marks()[1].note, "very far");
  EXPECT_EQ(rows.index(1, 1).data(), "very far");
  EXPECT_FALSE(rows.setData(rows.index(1, 0), "9 s", Qt::EditRole)) << "times are not edited";
  table->selectRow(0);
  EXPECT_TRUE(window.panels().bookmarks->removeButton()->isEnabled());
  window.panels().bookmarks->removeButton()->click();
  ASSERT_EQ(marks().size(), 1);
  EXPECT_EQ(marks()[0].t, 6.0);
  EXPECT_EQ(rows.rowCount(), 1);
  for (int step = 0; step < 3; ++step) window.document().steps().undo();
  EXPECT_TRUE(marks().isEmpty());
  EXPECT_EQ(rows.rowCount(), 0);
}

}  // namespace bookmark_test
}  // namespace abstand::ui
