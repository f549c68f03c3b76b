// The table of events.
#pragma once

#include <QWidget>

#include "ui/model/recording_review.hpp"

class QCheckBox;
class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace abstand::ui {

class EventTableModel;

/// Every intrusion, touch between frames and near miss under the present margins. A row that is chosen goes
/// to its nearest moment and chooses its pair. Hidden, it costs nothing. GUI thread only.
class EventPanel : public QWidget {
  Q_OBJECT

 public:
  /// The review outlives it.
  explicit EventPanel(const RecordingReview& review, QWidget* parent = nullptr);

  QTableView* table() const { return table_; }
  QCheckBox* nearMisses() const { return near_; }

 Q_SIGNALS:
  /// s; indices of the store.
  void picked(double t, int part, int link);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void choose(const QModelIndex& index);

  const RecordingReview& review_;
  EventTableModel* model_;
  QSortFilterProxyModel* sorted_;
  QCheckBox* near_;
  QLabel* count_;
  QTableView* table_;
  long shown_{-1};
};

}  // namespace abstand::ui
