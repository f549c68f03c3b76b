// Bookmarks by keys: added, visited with their camera, removed, undone.
#include <QAction>
#include <QInputDialog>
#include <QStatusBar>

#include "tests/ui/modal_answer.hpp"
#include "tests/ui/shown_window.hpp"
#include "ui/document/document.hpp"
#include "ui/model/playback.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {
namespace {

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

TEST_F(BookmarkTest, IsVisitedWithItsCameraAndNote) {
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

TEST_F(BookmarkTest, OneAFrameIsKeptRemovedAndUndone) {
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

}  // namespace
}  // namespace abstand::ui
