// The scrub bar: distance over the whole recording as a heat strip, contacts, playhead.
#pragma once

#include <QImage>
#include <QWidget>
#include <functional>
#include <vector>

#include "ui/model/moment_tips.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/stop_spans.hpp"
#include "ui/model/time_axis.hpp"

namespace abstand::ui {

class RunHistory;

/// The whole recording. Bright where the smallest distance of people and robots was small, dark where it was
/// large, grey where not yet computed. Vermillion bars where something touches, ochre ones inside a margin:
/// of the review, where there is one, else of what has been played, and there dark bars inside a margin that
/// has changed since. Marks
/// above it where events of the shown kinds begin. The playhead follows the pointer while the left button is
/// down; the wheel zooms the lanes, whose part of the time has a frame.
class TimeStrip : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kSide = 10;  ///< px left and right, for the playhead's handle at the ends

  /// Both outlive it.
  TimeStrip(const RecordingReview& review, TimeAxis& axis, QWidget* parent = nullptr);

  /// It lives in the owner; null for none.
  void setHistory(const RunHistory* history, double start, double end);
  void setTime(double t);
  /// s: marked above the strip.
  void setBookmarks(std::vector<double> times);
  /// In which robots stood, as far as it was played: a bar along the upper edge.
  void setStops(std::vector<StopSpan> stops);
  /// What the tool tip says of a stop; asked for while the pointer is over it.
  void setStopText(std::function<QString(const StopSpan&)> text) { stop_text_ = std::move(text); }
  void setTips(MomentTips tips) { tips_ = std::move(tips); }
  /// Repaints when the series have grown.
  void refresh();

  double timeAt(int x) const;
  int xOf(double t) const;
  QSize sizeHint() const override { return {400, 56}; }
  QSize minimumSizeHint() const override { return {160, 52}; }

 Q_SIGNALS:
  void scrubbed(double t);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRect band() const;
  void rebuild();
  void paintTicks(QPainter& painter) const;
  void paintMarks(QPainter& painter) const;
  void placeEvents();
  void paintEventMarks(QPainter& painter) const;
  void paintPlayhead(QPainter& painter) const;
  void paintView(QPainter& painter) const;
  void paintBookmarks(QPainter& painter) const;
  void paintStops(QPainter& painter) const;
  void rebuildFromReview();
  QString textAt(double t) const;
  QString tipAt(double t) const;
  QString momentAt(double t) const;

  const RecordingReview& review_;
  TimeAxis& axis_;
  const RunHistory* history_{nullptr};
  double start_{0.0}, end_{0.0}, time_{0.0};
  int hover_x_{-1};
  std::vector<double> bookmarks_;  // s
  std::vector<StopSpan> stops_;
  std::function<QString(const StopSpan&)> stop_text_;
  MomentTips tips_;
  QImage heat_;  // one row, a pixel a column
  struct {
    std::vector<bool> touching, inside, earlier;    // by column; `earlier`: inside a margin of before
    std::vector<std::pair<int, EventKind>> events;  // column and kind, those of less weight first
  } marks_;
  long shown_revision_{-1};
};

}  // namespace abstand::ui
