// When a part is hidden, as a strip in a row of a table.
#pragma once

#include <QStyledItemDelegate>

#include "ui/model/coverage_report.hpp"

namespace abstand::ui {

/// Draws in the cell of row i the hidden spans of part i over the recording, with a line at the present time.
/// A click in it is a time; the tip says what hides the part there. GUI thread only.
class CoverageStrip : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// It must live until the next call.
  void setReport(const CoverageReport* report) { report_ = report; }
  void setTime(double t) { time_ = t; }
  /// s, at a place of a cell, within the recording.
  double timeAt(const QRect& cell, int x) const;
  /// The span at or, if it is drawn narrower than a few pixels, next to a time; null: none.
  const CoverageSpan* spanAt(int row, double t, double slack) const;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override;

 Q_SIGNALS:
  /// The begin of the span that was clicked, otherwise the time under the pointer, s.
  void picked(double t);

 private:
  const CoveragePart* partOf(int row) const;
  QRect band(const QRect& cell) const { return cell.adjusted(4, 4, -4, -4); }
  int xOf(const QRect& cell, double t) const;

  const CoverageReport* report_{nullptr};
  double time_{0.0};
};

}  // namespace abstand::ui
