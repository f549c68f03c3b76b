// The events of a recording under the present margins.
#pragma once

#include <QAbstractTableModel>

#include "ui/model/recording_review.hpp"

namespace abstand::ui {

/// One row an event, in order of time. refresh() takes over what the review has; rows come and
/// go with the margins. GUI thread only.
class EventTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kTime, kDuration, kKind, kPart, kLink, kClearance, kError, kClosing, kStop, kColumns };
  /// Number or text to sort by.
  static constexpr int kSortRole = Qt::UserRole;

  /// The review outlives it.
  EventTableModel(const RecordingReview& review, QObject* parent);

  void refresh();
  const RecordingEvent& at(int row) const { return events_[static_cast<std::size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVariant text(const RecordingEvent& event, int column) const;
  QVariant key(const RecordingEvent& event, int column) const;

  const RecordingReview& review_;
  std::vector<RecordingEvent> events_;
};

}  // namespace abstand::ui
