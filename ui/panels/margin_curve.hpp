// What the margin of a body part costs: stopped time, false and missed stops against the margin.
#pragma once

#include <QWidget>
#include <vector>

#include "core/margin/part_curve.hpp"

class QComboBox;
class QLabel;
class QTimer;

namespace abstand::ui {

class CurveArea;
class RecordingReview;
class Selection;

/// Of the part that is chosen, with the present margins of the links; a handle is the part's present margin,
/// which the user can drag. Hidden, it costs nothing; else it is computed in slices of a few milliseconds.
/// GUI thread only.
class MarginCurve : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kStep = 0.005;    ///< m, between two points
  static constexpr double kRightEnd = 0.3;  ///< m, the curve's right end
  struct Point {
    double margin{0.0};  ///< m, of the row
    margin::MarginOutcome outcome;
  };

  /// Both outlive it.
  MarginCurve(const RecordingReview& review, const Selection& selection, QWidget* parent = nullptr);

  QComboBox* parts() const { return parts_; }
  QLabel* sentence() const { return sentence_; }
  /// As many as have been computed.
  const std::vector<Point>& points() const { return points_; }
  bool complete() const;
  /// Where the plot has a margin (m), and its handle.
  QWidget* area() const;
  QPoint handle() const;
  int xOf(double metres) const;

 Q_SIGNALS:
  /// The user drags the handle: the margin (m) of an object.
  void dragged(int object, double metres);
  void released();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  friend class CurveArea;
  void fillParts();
  void followSelection();
  void refresh();
  void compute();
  void say();
  /// Of the row that is shown, m.
  double present() const;
  int object() const;

  const RecordingReview& review_;
  const Selection& selection_;
  QComboBox* parts_;
  QLabel* sentence_;
  CurveArea* area_;
  QTimer* work_;
  std::vector<Point> points_;
  margin::PartMargins made_for_;  ///< of points_, at a row's margin of 0
  int part_{-1};                  ///< of the store, of points_
  long opened_{-1};               ///< RecordingReview::opened()
};

}  // namespace abstand::ui
