#include "tracking/tracker/through_spans.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quantile.hpp"

namespace abstand::tracking {
namespace {

constexpr double kThroughWindow = 0.5, kThroughLasts = 0.5;  // s
constexpr double kHighQuantile = 0.9;                        // quantile of the displacements

/// The median of the known ones; NaN: there is none.
double medianShare(std::span<const ThroughAt> seen) {
  std::vector<double> known;
  for (const ThroughAt& one : seen)
    if (!std::isnan(one.share)) known.push_back(one.share);
  return known.empty() ? kNaN : nearestQuantile(std::move(known), 0.5);
}

}  // namespace

ThroughAt throughAt(double t, const LabelledImage& a, const LabelledImage& b) {
  SeenThrough seen;
  seen.add(a, b);
  seen.add(b, a);
  if (seen.compared < ThroughAt::kFewest) return {.t = t};
  return {.t = t, .share = seen.share(), .displacement = seen.displacement()};
}

std::vector<ApartSpan> throughSpans(std::span<const ThroughAt> seen) {
  std::vector<ApartSpan> spans;
  std::vector<double> displacements;  // of the span that is open
  double first = kNaN, last = kNaN, begin = -kInfinity, end = kInfinity;
  bool has_agreed = false;
  std::size_t from = 0, to = 0;
  const auto close = [&](double until) {
    if (last - first >= kThroughLasts)
      spans.push_back({begin, until, nearestQuantile(displacements, kHighQuantile)});
    displacements.clear();
  };
  for (const ThroughAt& one : seen) {
    while (seen[from].t < one.t - 0.5 * kThroughWindow) ++from;
    while (to < seen.size() && seen[to].t <= one.t + 0.5 * kThroughWindow) ++to;
    const double share = medianShare(seen.subspan(from, to - from));
    if (std::isnan(share)) continue;
    if (share > ThroughAt::kShare) {
      if (displacements.empty()) {
        first = one.t;
        begin = has_agreed ? first : -kInfinity;
      }
      displacements.push_back(one.displacement);
      last = one.t;
      end = kInfinity;
      continue;
    }
    end = std::min(end, one.t);
    if (!displacements.empty() && one.t - last < kThroughLasts) continue;
    if (!displacements.empty()) close(end);
    has_agreed = true;
  }
  if (!displacements.empty()) close(kInfinity);
  return spans;
}

}  // namespace abstand::tracking
