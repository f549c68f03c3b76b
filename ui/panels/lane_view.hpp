// The lanes of the timeline: a row for each body part.
#pragma once

#include <QAbstractScrollArea>

#include "ui/model/moment_tips.hpp"
#include "ui/panels/lane_image.hpp"

namespace abstand::ui {

/// Bright where a part was near a robot, dark where it was far, hatched where it is not known; below, a bar
/// where it touched (vermillion), was inside its margin (ochre) or near it (amber). A click goes to the
/// moment and chooses the part and its nearest link; dragging scrubs; Ctrl and the wheel zoom, Shift and the
/// wheel move the time axis. Only the lanes and columns in view are computed. GUI thread only.
class LaneView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  static constexpr int kLaneHeight = 13;  ///< px
  static constexpr int kNameWidth = 112;  ///< px, left of the lanes
  static constexpr int kSide = 10;        ///< px, right of them

  /// Both outlive it.
  LaneView(const RecordingReview& review, TimeAxis& axis, QWidget* parent = nullptr);

  void setTime(double t);
  /// Objects of the scene; the names of their lanes are marked, and the first one is brought into view.
  void setSelected(const std::vector<int>& objects);
  bool isSelected(int lane) const;
  void setTips(MomentTips tips) { tips_ = std::move(tips); }
  int lanes() const;
  /// Of the viewport.
  int xOf(double t) const;
  double timeAt(int x) const;
  /// Lane at a height of the viewport, or -1.
  int laneAt(int y) const;
  /// As it is drawn.
  const LaneRow& row(int lane) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {240, 3 * kLaneHeight + 2}; }

 Q_SIGNALS:
  void scrubbed(double t);
  /// Indices of the store.
  void pairPicked(int part, int link);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  QRect area() const;
  void renew();
  void paintLane(QPainter& painter, int lane, const QRect& place) const;
  QString nameOf(int lane) const;
  QString tipAt(int lane, double t) const;

  MomentTips tips_;
  const RecordingReview& review_;
  TimeAxis& axis_;
  double time_{0.0};
  std::vector<int> selected_;          ///< objects, sorted
  mutable std::vector<LaneRow> rows_;  ///< of the lanes that were asked for
  mutable std::vector<std::size_t> bounds_;
};

}  // namespace abstand::ui
