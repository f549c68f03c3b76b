#include "tracking/tracker/span_collector.hpp"

#include <algorithm>
#include <utility>

#include "core/math/quantile.hpp"

namespace abstand::tracking {

void SpanCollector::add(double t, bool is_apart, double distance) {
  if (is_apart) {
    if (distances_.empty()) {
      first_ = t;
      begin_ = first_ - last_agreed_ > kGap ? last_agreed_ : first_;
    }
    distances_.push_back(distance);
    last_ = t;
    end_ = kInfinity;
    return;
  }
  end_ = std::min(end_, t);
  if (!distances_.empty() && t - last_ < kLasts) return;
  if (!distances_.empty()) close(end_);
  last_agreed_ = t;
}

std::vector<ApartSpan> SpanCollector::finish() {
  if (!distances_.empty()) close(kInfinity);
  return std::move(spans_);
}

void SpanCollector::close(double until) {
  if (last_ - first_ >= kLasts)
    spans_.push_back({begin_, until, nearestQuantile(distances_, kNearlyFarthest)});
  distances_.clear();
}

}  // namespace abstand::tracking
