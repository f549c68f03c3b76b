#include "ui/model/event_table_model.hpp"

#include <gtest/gtest.h>

#include "tests/ui/fake_analysis.hpp"

namespace abstand::ui {
namespace event_table_test {

using Column = EventTableModel::Column;

TEST(EventTable, HasOneRowPerEvent) {
  FakeSession session;
  FakeAnalysis analysis(session.outline(), [&](std::size_t part, std::size_t frame) {
    return part == 3 ? -0.02 + valley(part, analysis.t(frame)) - 0.05 : valley(part, analysis.t(frame));
  });
  analysis.runAll();
  RecordingReview review;
  std::vector<double> margins(session.outline().objects.size(), 0.0);
  margins[analysis.layout().parts[2].object] = 0.1;
  margins[analysis.layout().parts[5].object] = 0.04;
  review.open(&analysis, session.outline(), margins);
  review.pull();
  EventTableModel model(review, nullptr);
  EXPECT_EQ(model.rowCount(), 0);
  model.refresh();
  ASSERT_EQ(model.rowCount(), static_cast<int>(review.events().size()));
  const auto text = [&](int row, Column column) {
    return model.data(model.index(row, column), Qt::DisplayRole).toString().toStdString();
  };
  int inside = -1, near = -1, touch = -1;
  for (int row = 0; row < model.rowCount(); ++row) {
    if (text(row, Column::kPart) == "biceps_left") inside = row;
    if (text(row, Column::kPart) == "forearm_right") near = row;
    if (text(row, Column::kPart) == "biceps_right" && text(row, Column::kKind) == "inside margin")
      touch = row;
  }
  ASSERT_GE(inside, 0);
  EXPECT_EQ(text(inside, Column::kKind), "inside margin");
  EXPECT_EQ(text(inside, Column::kLink), "arm/link0");
  EXPECT_EQ(text(inside, Column::kClearance), "39.0 mm") << "40 mm, and 1 mm nearer between two frames";
  EXPECT_EQ(text(inside, Column::kError), "10.0 mm");
  EXPECT_EQ(text(inside, Column::kClosing), "0.50 m/s");
  EXPECT_EQ(text(inside, Column::kStop), "false");
  ASSERT_GE(near, 0);
  EXPECT_EQ(text(near, Column::kKind), "near miss");
  EXPECT_EQ(text(near, Column::kClearance), "70.0 mm");
  EXPECT_EQ(text(near, Column::kStop), "");
  ASSERT_GE(touch, 0) << "a touch is inside a margin of nothing";
  EXPECT_EQ(text(touch, Column::kStop), "⚠ missed");
  EXPECT_EQ(model.data(model.index(inside, Column::kTime), EventTableModel::kSortRole).toDouble(),
            model.at(inside).t0);
}

}  // namespace event_table_test
}  // namespace abstand::ui
