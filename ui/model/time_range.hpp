// A stretch of a recording.
#pragma once

namespace abstand::ui {

/// From `from` to `to`, s.
struct TimeRange {
  double from{0.0}, to{0.0};

  double length() const { return to - from; }
  bool contains(double t) const { return t >= from && t <= to; }
  bool operator==(const TimeRange&) const = default;
};

}  // namespace abstand::ui
