// The list of bookmarks.
#pragma once

#include <QVector>
#include <QWidget>

class QPushButton;
class QTableView;

namespace abstand::ui {

class BookmarkTable;
struct Bookmark;

/// A row that is clicked goes to its bookmark; notes are edited in place. Shows the document's bookmarks and
/// requests their changes. GUI thread only.
class BookmarkPanel : public QWidget {
  Q_OBJECT

 public:
  explicit BookmarkPanel(QWidget* parent = nullptr);

  void show(const QVector<Bookmark>& bookmarks);
  QTableView* table() const { return table_; }
  QPushButton* removeButton() const { return remove_; }

 Q_SIGNALS:
  void picked(int row);
  void noteWanted(int row, const QString& note);
  void removeWanted(int row);

 private:
  BookmarkTable* bookmarks_;
  QTableView* table_;
  QPushButton* remove_;
};

}  // namespace abstand::ui
