#include "ui/model/bookmarks.hpp"

#include <gtest/gtest.h>

#include <QSignalSpy>

namespace abstand::ui {
namespace {

TEST(Bookmarks, AreMomentsWithNotesInOrderOfTime) {
  Bookmarks bookmarks;
  const QSignalSpy changes(&bookmarks, &Bookmarks::changed);
  EXPECT_EQ(bookmarks.add(3.0), 0);
  EXPECT_EQ(bookmarks.add(1.5), 0);
  EXPECT_EQ(bookmarks.add(2.0), 1);
  EXPECT_EQ(bookmarks.add(2.0), 1) << "one for a moment";
  EXPECT_EQ(changes.size(), 3);
  EXPECT_TRUE(bookmarks.setData(bookmarks.index(1, Bookmarks::kNote), "hand near link7", Qt::EditRole));
  EXPECT_FALSE(bookmarks.setData(bookmarks.index(1, Bookmarks::kTime), 9.0, Qt::EditRole));
  EXPECT_EQ(bookmarks.all(), (std::vector<Bookmark>{{1.5, {}}, {2.0, "hand near link7"}, {3.0, {}}}));
  EXPECT_TRUE(bookmarks.flags(bookmarks.index(0, Bookmarks::kNote)) & Qt::ItemIsEditable);
  bookmarks.remove(0);
  bookmarks.remove(7);
  EXPECT_EQ(bookmarks.rowCount(), 2);
  EXPECT_EQ(changes.size(), 5);
  bookmarks.set({{5.0, "b"}, {4.0, "a"}});
  EXPECT_EQ(bookmarks.all().front().note, "a");
  EXPECT_EQ(changes.size(), 6);
  bookmarks.set(bookmarks.all());
  EXPECT_EQ(changes.size(), 6);
}

}  // namespace
}  // namespace abstand::ui
