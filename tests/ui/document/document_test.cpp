// The document: edits, undo, what counts as modified.
#include "ui/document/document.hpp"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <random>

#include "tests/ui/document/sample_project.hpp"

namespace abstand::ui {
namespace document_test {

TEST(DocumentTest, UndoOfRandomEditsRestoresStart) {
  Document document;
  document.open(sampleProject(), "/p.abstand", false);
  const Work start = document.work();
  std::mt19937 random(7);
  const auto number = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<Work> states{start};
  while (states.size() < 300) {
    const QString object = QString::number(number(5));
    document.edit("edit", [&](Work& work) {
      switch (number(6)) {
        case 0:
          work.margins[object] = 0.001 * number(300);
          break;
        case 1:
          work.margins.clear();
          break;
        case 2:
          if (!work.hidden.remove(object)) work.hidden += object;
          break;
        case 3:
          work.moved[{object, "x"}] = QString::number(number(3));
          break;
        case 4:
          work.bookmarks.push_back({0.1 * number(90), object, std::nullopt});
          break;
        default:
          work.range = TimeRange{0.01 * number(100), 2.0};
      }
    });
    if (!(document.work() == states.back())) states.push_back(document.work());
  }
  EXPECT_EQ(document.steps().count(), static_cast<int>(states.size()) - 1);
  for (auto state = states.rbegin(); state != states.rend(); ++state) {
    ASSERT_EQ(document.work(), *state);
    document.steps().undo();
  }
  EXPECT_EQ(document.work(), start);
  EXPECT_FALSE(document.modified());
  while (document.steps().canRedo()) document.steps().redo();
  EXPECT_EQ(document.work(), states.back());
}

TEST(DocumentTest, EachDragIsOneStep) {
  Document document;
  const auto drag = [&](std::initializer_list<double> values) {
    for (const double value : values)
      document.edit(
          "margin of a", [&](Work& work) { work.margins["a"] = value; }, "margins");
    document.endStep();
  };
  drag({0.1, 0.2, 0.3});
  drag({0.4, 0.5});
  EXPECT_EQ(document.steps().count(), 2);
  document.steps().undo();
  EXPECT_EQ(document.work().margins.value("a"), 0.3);
  document.steps().undo();
  EXPECT_EQ(document.work(), Work());
}

TEST(DocumentTest, DragBackToStartLeavesNoStep) {
  Document document;
  for (const double value : {0.1, 0.2, 0.0})
    document.edit(
        "margin",
        [&](Work& work) {
          work.margins.clear();
          if (value > 0.0) work.margins["a"] = value;
        },
        "margins");
  EXPECT_EQ(document.steps().count(), 0);
  document.edit("nothing", [](Work&) {});
  EXPECT_EQ(document.steps().count(), 0);
  EXPECT_FALSE(document.modified());
}

TEST(DocumentTest, IsModifiedUntilSavedAndAgainAfterUndo) {
  Document document;
  QSignalSpy titles(&document, &Document::titleChanged);
  document.edit("hide a", [](Work& work) { work.hidden += "a"; });
  EXPECT_TRUE(document.modified());
  document.setSaved("/p.abstand");
  EXPECT_FALSE(document.modified());
  EXPECT_EQ(document.file(), "/p.abstand");
  document.steps().undo();
  EXPECT_TRUE(document.modified());
  document.steps().redo();
  EXPECT_FALSE(document.modified());
  EXPECT_GE(titles.size(), 4);
  document.setViewpoint({CameraView{}, 3.0});
  EXPECT_FALSE(document.modified()) << "to look around is no work";
  document.open(sampleProject(), "/q.abstand", true);
  EXPECT_TRUE(document.modified());
  EXPECT_FALSE(document.steps().canUndo());
}

TEST(DocumentTest, SignalsEditUndoAndRedo) {
  Document document;
  std::vector<std::pair<int, int>> heard;
  QObject::connect(&document, &Document::workChanged, [&](const Work& before, const Work& after) {
    heard.emplace_back(before.hidden.size(), after.hidden.size());
  });
  document.edit("hide a", [](Work& work) { work.hidden += "a"; });
  document.steps().undo();
  document.steps().redo();
  EXPECT_EQ(heard, (std::vector<std::pair<int, int>>{{0, 1}, {1, 0}, {0, 1}}));
}

}  // namespace document_test
}  // namespace abstand::ui
