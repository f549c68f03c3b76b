// The list of bookmarks.
#pragma once

#include <QWidget>

class QPushButton;
class QTableView;

namespace abstand::ui {

class Bookmarks;

/// A row that is chosen goes to its moment; notes are edited in place. GUI thread only.
class BookmarkPanel : public QWidget {
  Q_OBJECT

 public:
  /// The bookmarks outlive it.
  explicit BookmarkPanel(Bookmarks& bookmarks, QWidget* parent = nullptr);

  QTableView* table() const { return table_; }
  QPushButton* removeButton() const { return remove_; }

 Q_SIGNALS:
  void picked(double t);

 private:
  Bookmarks& bookmarks_;
  QTableView* table_;
  QPushButton* remove_;
};

}  // namespace abstand::ui
