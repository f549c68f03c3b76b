// The time axis of the timeline: which part of the recording is in view, and which range is chosen.
#pragma once

#include <QObject>
#include <optional>

#include "ui/model/time_range.hpp"

namespace abstand::ui {

/// Shared by the strip, the lanes and whoever stores the chosen range. Times in seconds of the recording. GUI
/// thread only.
class TimeAxis : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// The whole recording; everything of it is in view, and no range is chosen. `period`: s, of a frame.
  void open(double start, double end, double period);

  const TimeRange& whole() const { return whole_; }
  /// What is in view, within whole().
  const TimeRange& view() const { return view_; }
  bool zoomed() const { return view_ != whole_; }
  /// What is chosen between IN and OUT; none: everything.
  const std::optional<TimeRange>& range() const { return range_; }

  /// Clamped to whole(), and to no fewer than four frames.
  void setView(TimeRange view);
  /// Below 1: shows less time, around `t`, which keeps its place.
  void zoom(double factor, double t);
  /// By steps of the wheel: positive ones show less time.
  void zoomSteps(double steps, double t);
  /// By a share of what is in view.
  void pan(double share);
  void showAll() { setView(whole_); }
  /// Pans by as little as brings `t` into view.
  void reveal(double t);

  /// Clamped to whole(); a range that is empty or turned round is none.
  void setRange(std::optional<TimeRange> range);
  /// Moves one end; the other one stays, or is that of the recording. An end beyond the other one takes the
  /// other one to the recording's end.
  void setIn(double t);
  void setOut(double t);

 Q_SIGNALS:
  void viewChanged();
  void rangeChanged();

 private:
  TimeRange whole_, view_;
  std::optional<TimeRange> range_;
  double period_{0.01};
};

}  // namespace abstand::ui
