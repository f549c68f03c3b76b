// One value a frame of the timeline.
#include "ui/model/frame_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abstand::ui {

namespace {
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kShortestPeriod = 1e-6;  // s; shorter frames than this nobody can tell apart on the screen
}  // namespace

FrameSeries::FrameSeries(double start, double end, double period, Keep keep)
    : start_{start}, period_{std::max(period, kShortestPeriod)}, keep_{keep}, open_end_{!(end > start)} {
  if (open_end_) return;
  period_ = std::max(period_, (end - start) / static_cast<double>(kMaxFrames - 1));
  values_.assign(static_cast<std::size_t>(std::lround((end - start) / period_)) + 1, kUnknown);
}

void FrameSeries::add(double t, double value) {
  const double position = std::round((t - start_) / period_);
  if (!std::isfinite(value) || !(position >= 0.0) || position > 1e15) return;
  auto frame = static_cast<std::size_t>(position);
  if (frame >= values_.size()) {
    if (!open_end_) return;
    if (frame >= kMaxFrames) {
      // Forget the older half, or everything before a jump ahead.
      const std::size_t drop = std::min(values_.size(), kMaxFrames / 2);
      values_.erase(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(drop));
      const std::size_t shift = std::max(drop, frame - std::min(frame, kMaxFrames / 2));
      if (shift > drop) values_.clear();
      start_ += static_cast<double>(shift) * period_;
      frame -= shift;
      last_frame_ = static_cast<std::size_t>(-1);
    }
    values_.resize(frame + 1, kUnknown);
  }
  double& slot = values_[frame];
  if (frame != last_frame_ || std::isnan(slot))
    slot = value;
  else
    slot = keep_ == Keep::kSmallest ? std::min(slot, value) : std::max(slot, value);
  last_frame_ = frame;
  ++revision_;
}

void FrameSeries::forget(double from, double to) {
  const double first = std::max(0.0, std::round((from - start_) / period_));
  const double last =
      std::min(static_cast<double>(values_.size()) - 1.0, std::round((to - start_) / period_));
  if (!(first <= last)) return;
  std::fill(values_.begin() + static_cast<std::ptrdiff_t>(first),
            values_.begin() + static_cast<std::ptrdiff_t>(last) + 1, kUnknown);
  last_frame_ = static_cast<std::size_t>(-1);
  ++revision_;
}

double FrameSeries::at(double t) const {
  const double position = std::round((t - start_) / period_);
  if (!(position >= 0.0) || position >= static_cast<double>(values_.size())) return kUnknown;
  return values_[static_cast<std::size_t>(position)];
}

Extremes FrameSeries::between(double left, double right) const {
  Extremes extremes{kUnknown, kUnknown};
  if (values_.empty()) return extremes;
  const double first = std::max(0.0, std::round((left - start_) / period_));
  const double last =
      std::min(static_cast<double>(values_.size() - 1), std::round((right - start_) / period_));
  for (double f = first; f <= last; ++f) {
    const double v = values_[static_cast<std::size_t>(f)];
    extremes.low = std::fmin(extremes.low, v);
    extremes.high = std::fmax(extremes.high, v);
  }
  return extremes;
}

void FrameSeries::decimate(double left, double right, int columns, std::vector<SeriesPoint>& out) const {
  out.clear();
  if (values_.empty() || !(right > left) || columns < 1) return;
  const double column_width = (right - left) / columns;
  const auto n = static_cast<double>(values_.size());
  // One frame more on either side, so that lines reach the edges.
  const double first = std::clamp(std::floor((left - start_) / period_), 0.0, n);
  const double last = std::clamp(std::ceil((right - start_) / period_) + 1.0, 0.0, n);

  SeriesPoint low{}, high{};
  bool open = false, gap = false;
  double column = 0.0;
  const auto close = [&] {
    if (!open) return;
    const bool low_first = low.t <= high.t;
    out.push_back(low_first ? low : high);
    if (low.t != high.t) out.push_back(low_first ? high : low);
    open = false;
  };
  for (auto f = static_cast<std::size_t>(first); f < static_cast<std::size_t>(last); ++f) {
    const SeriesPoint point{time(f), values_[f]};
    const double this_column = std::floor((point.t - left) / column_width);
    if (open && this_column != column) close();
    if (std::isnan(point.value)) {
      gap = true;
      continue;
    }
    if (!open) {
      // A gap inside a column cannot be seen; one between columns parts the line.
      if (gap && !out.empty() && out.back().t < point.t - 1.5 * period_) out.push_back({point.t, kUnknown});
      low = high = point;
      open = true;
      column = this_column;
    }
    gap = false;
    if (point.value < low.value) low = point;
    if (point.value > high.value) high = point;
  }
  close();
}

}  // namespace abstand::ui
