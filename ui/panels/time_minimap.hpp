// The whole recording below the zoomed lanes.
#pragma once

#include <QImage>
#include <QWidget>

#include "ui/model/recording_review.hpp"
#include "ui/model/time_axis.hpp"

namespace abstand::ui {

/// A thin heat strip of the smallest clearance over the whole recording, with a frame around what the lanes
/// show. Dragging the frame moves what they show, dragging an end of it changes how much; a press beside it
/// centres it there. Hidden while the lanes show everything. GUI thread only.
class TimeMinimap : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kHeight = 16;  ///< px
  static constexpr int kSide = 10;    ///< px left and right, as TimeStrip

  /// Both outlive it.
  TimeMinimap(const RecordingReview& review, TimeAxis& axis, QWidget* parent = nullptr);

  /// s.
  void setTime(double t);
  double timeAt(int x) const;
  int xOf(double t) const;
  QSize sizeHint() const override { return {400, kHeight}; }
  QSize minimumSizeHint() const override { return {160, kHeight}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  enum class Grip { kNone, kFrom, kTo, kWhole };
  QRect band() const;
  QRect frame() const;
  Grip gripAt(int x) const;
  void showState();
  void rebuild();

  const RecordingReview& review_;
  TimeAxis& axis_;
  double time_{0.0};
  QImage heat_;  ///< one row, a pixel a column; null: to be made anew
  Grip grip_{Grip::kNone};
  double grabbed_{0.0};  ///< s, from the start of the view to the pointer
};

}  // namespace abstand::ui
