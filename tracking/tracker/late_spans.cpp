#include "tracking/tracker/late_spans.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/tracker/clock_offset.hpp"

namespace abstand::tracking {
namespace {

constexpr double kLateWindow = 2.5, kLateStep = 0.5;  // s
constexpr double kSameLate = 0.07;                    // s, two images

ClockOffset clockOffsetIn(std::span<const SeenTwice> window) {
  std::vector<humanmodel::SkeletonFrame> first, second;
  for (const SeenTwice& one : window) {
    first.push_back(one.first);
    second.push_back(one.second);
  }
  return estimateClockOffset(first, second);
}

}  // namespace

std::vector<LateSpan> lateSpans(std::span<const SeenTwice> seen) {
  std::vector<LateSpan> spans;
  if (seen.empty()) return spans;
  double last = 0.0;  // s, of the window before; 0: none, or none that shows a difference
  bool is_open = false;
  const auto at = [&](double t) {
    return std::lower_bound(seen.begin(), seen.end(), t,
                            [](const SeenTwice& one, double time) { return one.t < time; });
  };
  for (double t = seen.front().t; t + kLateWindow <= seen.back().t + kLateStep; t += kLateStep) {
    const ClockOffset found = clockOffsetIn({at(t), at(t + kLateWindow)});
    const double late = -found.offset;
    const bool is_late = std::abs(late) >= LateSpan::kLate && found.refutesZero();
    if (!is_late && !found.decided) continue;
    if (is_open && is_late) {
      spans.back().late = std::abs(late) > std::abs(spans.back().late) ? late : spans.back().late;
    } else if (is_open) {
      spans.back().until = t + kLateWindow;
      is_open = false;
    } else if (is_late && std::abs(late - last) < kSameLate) {
      spans.push_back({t - kLateStep, kInfinity, late});
      is_open = true;
    }
    last = is_late ? late : 0.0;
  }
  return spans;
}

}  // namespace abstand::tracking
