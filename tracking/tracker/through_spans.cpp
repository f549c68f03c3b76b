#include "tracking/tracker/through_spans.hpp"

#include <cmath>

#include "core/math/quantile.hpp"
#include "tracking/tracker/span_collector.hpp"

namespace abstand::tracking {
namespace {

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
  SpanCollector spans;
  forEachWindow(seen, [&](const ThroughAt& one, std::span<const ThroughAt> window) {
    if (const double share = medianShare(window); !std::isnan(share))
      spans.add(one.t, share > ThroughAt::kShare, one.displacement);
  });
  return spans.finish();
}

}  // namespace abstand::tracking
