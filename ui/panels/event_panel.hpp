// The table of events.
#pragma once

#include <QWidget>
#include <array>

#include "ui/model/recording_review.hpp"

class QAction;
class QLabel;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;

namespace abstand::ui {

class EventTableModel;

/// Every touch, intrusion, touch between frames and near miss under the present margins, every stop as it was
/// played, and every loss of tracking. A row that is chosen goes to its nearest moment and chooses its pair.
/// Hidden, it costs nothing. GUI thread only.
class EventPanel : public QWidget {
  Q_OBJECT

 public:
  /// The review outlives it.
  explicit EventPanel(const RecordingReview& review, QWidget* parent = nullptr);

  QTableView* table() const { return table_; }
  /// Shows a kind, or not.
  QAction* kindAction(EventKind kind) const { return kind_actions_[static_cast<std::size_t>(kind)]; }

 Q_SIGNALS:
  /// s; indices of the store.
  void picked(double t, int part, int link);
  /// s; of SceneOutline::pairs, -1: none.
  void stopPicked(double t, int pair);
  /// The kinds that shall be shown.
  void kindsWanted(abstand::ui::EventKinds kinds);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void buildKinds();
  void refresh();
  void choose(const QModelIndex& index);

  const RecordingReview& review_;
  EventTableModel* model_;
  QSortFilterProxyModel* sorted_;
  QToolButton* kinds_;
  std::array<QAction*, kEventKinds> kind_actions_{};
  QLabel* count_;
  QTableView* table_;
  long shown_{-1};
};

}  // namespace abstand::ui
