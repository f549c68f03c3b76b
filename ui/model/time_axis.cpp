// The time axis of the timeline.
#include "ui/model/time_axis.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::ui {

namespace {

constexpr double kFewestFrames = 4.0;
constexpr double kZoomStep = 1.25;

}  // namespace

void TimeAxis::open(double start, double end, double period) {
  whole_ = {start, std::max(start, end)};
  period_ = period;
  view_ = whole_;
  range_.reset();
  Q_EMIT viewChanged();
  Q_EMIT rangeChanged();
}

void TimeAxis::setView(TimeRange view) {
  const double length =
      std::clamp(view.length(), std::min(whole_.length(), kFewestFrames * period_), whole_.length());
  view.from = std::clamp(view.from, whole_.from, whole_.to - length);
  view.to = view.from + length;
  // The end stays exact.
  if (length == whole_.length()) view = whole_;
  if (view == view_) return;
  view_ = view;
  Q_EMIT viewChanged();
}

void TimeAxis::zoom(double factor, double t) {
  t = std::clamp(t, view_.from, view_.to);
  setView({t - factor * (t - view_.from), t + factor * (view_.to - t)});
}

void TimeAxis::zoomSteps(double steps, double t) { zoom(std::pow(kZoomStep, -steps), t); }

void TimeAxis::pan(double share) {
  const double step = share * view_.length();
  setView({view_.from + step, view_.to + step});
}

void TimeAxis::reveal(double t) {
  if (t < view_.from) setView({t, t + view_.length()});
  if (t > view_.to) setView({t - view_.length(), t});
}

void TimeAxis::setRange(std::optional<TimeRange> range) {
  if (range) {
    range->from = std::clamp(range->from, whole_.from, whole_.to);
    range->to = std::clamp(range->to, whole_.from, whole_.to);
    if (!(range->length() > 0.0)) range.reset();
  }
  if (range == range_) return;
  range_ = range;
  Q_EMIT rangeChanged();
}

void TimeAxis::setIn(double t) {
  const double to = range_ && range_->to > t ? range_->to : whole_.to;
  setRange(TimeRange{t, to});
}

void TimeAxis::setOut(double t) {
  const double from = range_ && range_->from < t ? range_->from : whole_.from;
  setRange(TimeRange{from, t});
}

}  // namespace abstand::ui
