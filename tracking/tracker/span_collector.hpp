// Spans of time in which two cameras disagree, from single times.
#pragma once

#include <span>
#include <vector>

#include "tracking/tracker/apart_spans.hpp"

namespace abstand::tracking {

/// Joins times at which cameras disagree to spans that last kLasts or longer; a span ends when they agree for
/// as long. Longer times than kGap before it of which nothing is known belong to it, as either state may hold
/// then. One thread; allocates.
class SpanCollector {
 public:
  /// `t` (s) increases. `distance` (m), of cameras that are apart.
  void add(double t, bool is_apart, double distance);
  /// After the last time.
  std::vector<ApartSpan> finish();

  static constexpr double kLasts = 0.5, kGap = 0.1;  ///< s
  static constexpr double kNearlyFarthest = 0.9;     ///< quantile of the distances of a span

 private:
  void close(double until);

  std::vector<ApartSpan> spans_;
  std::vector<double> distances_;  // of the span that is open
  // s: begin of the span, its first and last time, the last one before it and the first one after it
  double begin_{-kInfinity}, first_{kNaN}, last_{kNaN}, last_agreed_{-kInfinity}, end_{kInfinity};
};

/// Calls use(one, those of `seen` within half of kWindow of it) for each, by increasing time.
template <class Seen, class Use>
void forEachWindow(std::span<const Seen> seen, Use use) {
  constexpr double kWindow = 0.5;  // s
  std::size_t from = 0, to = 0;
  for (const Seen& one : seen) {
    while (seen[from].t < one.t - 0.5 * kWindow) ++from;
    while (to < seen.size() && seen[to].t <= one.t + 0.5 * kWindow) ++to;
    use(one, seen.subspan(from, to - from));
  }
}

}  // namespace abstand::tracking
