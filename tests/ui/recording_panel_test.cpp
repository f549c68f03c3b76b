// The card of a recording: what is shown, and that guesses stand out.
#include "ui/panels/recording_panel.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QTreeWidget>

#include "ui/style/theme.hpp"

namespace abstand::ui {
namespace recording_panel_test {

view::RecordingCard boxer() {
  view::RecordingCard card;
  card.person = "operator";
  card.file = "/somewhere/boxing.bvh";
  card.format = "bvh";
  card.frames = 3069;
  card.duration = 30.68;
  card.rate = 100.0;
  card.rate_reason = "the file says so";
  card.units = {"cm", "along the bones the person is 173 units tall", true};
  card.up = {"y", "said in the scene", false};
  card.stature = 1.7352;
  card.stature_reason = "along the bones";
  card.joint_map = {"guessed from the shape", "no map matches the names", true};
  return card;
}

/// The row of a property in the block of the first recording; null if it is not there.
QTreeWidgetItem* row(const RecordingPanel& panel, const QString& property) {
  QTreeWidgetItem* block = panel.tree().topLevelItem(0);
  for (int i = 0; i < block->childCount(); ++i)
    if (block->child(i)->text(0) == property) return block->child(i);
  return nullptr;
}

TEST(RecordingPanelTest, ShowsHowFileWasRead) {
  QAction options(QStringLiteral("Options"));
  RecordingPanel panel(&options);
  panel.open({boxer()});
  EXPECT_EQ(panel.tree().topLevelItem(0)->text(0), QStringLiteral("operator"));
  EXPECT_EQ(panel.tree().topLevelItem(0)->text(1), QStringLiteral("boxing.bvh"));
  ASSERT_TRUE(row(panel, QStringLiteral("Units")));
  EXPECT_EQ(row(panel, QStringLiteral("Units"))->text(1), QStringLiteral("cm (guessed)"));
  EXPECT_EQ(row(panel, QStringLiteral("Units"))->foreground(1).color(), QColor(kVermillion));
  EXPECT_FALSE(row(panel, QStringLiteral("Units"))->text(2).isEmpty());
  EXPECT_EQ(row(panel, QStringLiteral("Vertical axis"))->text(1), QStringLiteral("y"));
  EXPECT_NE(row(panel, QStringLiteral("Vertical axis"))->foreground(1).color(), QColor(kVermillion));
  EXPECT_EQ(row(panel, QStringLiteral("Stature"))->text(1), QStringLiteral("1.735 m"));
  EXPECT_EQ(row(panel, QStringLiteral("Length"))->text(1), QStringLiteral("30.68 s, 3069 frames"));
  EXPECT_EQ(row(panel, QStringLiteral("Stature"))->text(2), QStringLiteral("along the bones"));
  EXPECT_EQ(row(panel, QStringLiteral("Joint map"))->foreground(1).color(), QColor(kVermillion));
  EXPECT_FALSE(row(panel, QStringLiteral("Warning")));
}

TEST(RecordingPanelTest, ShowsWhatIsMissing) {
  QAction options(QStringLiteral("Options"));
  RecordingPanel panel(&options);
  view::RecordingCard cut = boxer();
  cut.frames_missing = 2840;
  cut.stature = 0.0;
  cut.missing_parts = {"hand_left", "hand_right"};
  panel.open({cut});
  EXPECT_EQ(row(panel, QStringLiteral("Stature"))->text(1), QStringLiteral("not known"));
  QStringList warnings;
  QTreeWidgetItem* block = panel.tree().topLevelItem(0);
  for (int i = 0; i < block->childCount(); ++i)
    if (block->child(i)->text(0) == QStringLiteral("Warning")) warnings << block->child(i)->text(1);
  ASSERT_EQ(warnings.size(), 2);
  EXPECT_TRUE(warnings[0].contains(QStringLiteral("hand_left, hand_right")));
  EXPECT_TRUE(warnings[1].contains(QStringLiteral("2840")));
  panel.open({});
  EXPECT_EQ(panel.tree().topLevelItem(0)->text(0), QStringLiteral("No recording"));
}

}  // namespace recording_panel_test
}  // namespace abstand::ui
