// Two sets of margins below each other: when the robot would have stood.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/margin/margin_review.hpp"
#include "ui/model/time_range.hpp"
#include "ui/model/what_if_settings.hpp"

namespace abstand::ui {

class ElidedLabel;
class RecordingReview;
class TimeAxis;

/// Set A, the present margins, and set B, those that were kept; hidden while there is no set B. GUI thread
/// only.
class CompareLanes : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kLaneHeight = 13;  ///< px

  /// Both outlive it.
  CompareLanes(const RecordingReview& review, const TimeAxis& axis, QWidget* parent = nullptr);

  /// Set B: m, of each object; empty: none.
  void setCompared(std::vector<double> margins);
  void setTime(double t);
  /// The difference in words.
  QString text() const;
  /// Of set A (0) or B (1).
  const std::vector<TimeRange>& stops(int set) const { return stops_[set]; }
  const margin::MarginOutcome& compared() const { return kept_.outcome; }
  QSize sizeHint() const override;

 Q_SIGNALS:
  void closeWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();
  QRect lane(int set) const;

  const RecordingReview& review_;
  const TimeAxis& axis_;
  ElidedLabel* sentence_;
  QWidget* head_;
  std::vector<double> margins_;
  margin::MarginReviewer reviewer_;
  margin::MarginReview kept_;
  long opened_{-1};
  WhatIfSettings settings_;
  double time_{0.0};  ///< s
  bool judged_{false};
  std::vector<TimeRange> stops_[2];
};

}  // namespace abstand::ui
