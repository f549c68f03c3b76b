// One value a frame of the timeline, as far as it has been computed; the charts and the time strip draw from
// it.
#pragma once

#include <cstddef>
#include <vector>

namespace abstand::ui {

/// Which of several values that fall into one frame stays.
enum class Keep { kSmallest, kLargest };

/// Lowest and highest value of a stretch of time; NaN where nothing is known.
struct Extremes {
  double low, high;
};

struct SeriesPoint {
  double t, value;
};

/// Values over [start, end] in frames of `period`. A frame that is played again takes the new values. With
/// end <= start the end is open: the series grows, and forgets its first half when it is full. GUI thread
/// only.
class FrameSeries {
 public:
  static constexpr std::size_t kMaxFrames = std::size_t{1} << 20;

  FrameSeries() = default;
  /// A period that would need more than kMaxFrames frames is made longer.
  FrameSeries(double start, double end, double period, Keep keep);

  /// A time outside the range or a value that is not finite is passed over.
  void add(double t, double value);

  /// What is known of [from, to] (s) is known no more.
  void forget(double from, double to);

  std::size_t size() const { return values_.size(); }
  double value(std::size_t frame) const { return values_[frame]; }
  double time(std::size_t frame) const { return start_ + static_cast<double>(frame) * period_; }
  double start() const { return start_; }
  double period() const { return period_; }
  double last() const { return values_.empty() ? start_ : time(values_.size() - 1); }
  /// Value of the frame nearest to t; NaN where nothing is known.
  double at(double t) const;
  /// Of all frames that overlap [left, right] by half a period or more, at least the nearest one.
  Extremes between(double left, double right) const;
  /// Grows with every value that was added, and when values were forgotten.
  long revision() const { return revision_; }

  /// Replaces `out` by at most two points a column of [left, right] divided into `columns`: the lowest and
  /// highest value of the column in order of time, so that no extreme is lost. A NaN value parts what is not
  /// connected.
  void decimate(double left, double right, int columns, std::vector<SeriesPoint>& out) const;

 private:
  double start_{0.0}, period_{1.0};
  Keep keep_{Keep::kSmallest};
  bool open_end_{true};
  std::vector<double> values_;
  std::size_t last_frame_{static_cast<std::size_t>(-1)};
  long revision_{0};
};

}  // namespace abstand::ui
