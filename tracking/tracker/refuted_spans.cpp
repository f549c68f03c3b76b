#include "tracking/tracker/refuted_spans.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/quantile.hpp"

namespace abstand::tracking {
namespace {

constexpr double kKnown = 0.5;  // share of the times at which the bodies were compared

template <class Seen>
std::vector<Seen> during(const ApartSpan& span, std::span<const Seen> seen) {
  std::vector<Seen> those;
  std::copy_if(seen.begin(), seen.end(), std::back_inserter(those),
               [&](const Seen& one) { return one.t >= span.since && one.t < span.until; });
  return those;
}

/// m, of `off` across the ray from a camera to a place; and the distance.
struct Across {
  double aside, distance;
};
Across across(const Vector3d& off, const Vector3d& p_W, const DepthCamera& camera) {
  const Vector3d ray = p_W - camera.X_WC.translation();
  const Vector3d along = ray.normalized();
  return {(off - off.dot(along) * along).norm(), ray.norm()};
}

std::optional<Vector3d> placeOf(const humanmodel::SkeletonFrame& frame) {
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (frame.has(static_cast<humanmodel::Joint>(j))) return frame.p[j];
  return std::nullopt;
}

/// Whether one of the cameras would see through a person who is off like that.
bool wouldShow(const SeenTwice& one, const DepthCamera& first, const DepthCamera& second) {
  const std::optional<Vector3d> a = placeOf(one.first), b = placeOf(one.second);
  if (!a || !b) return false;
  const Across by_first = across(one.off, *b, first), by_second = across(one.off, *a, second);
  const double far = SeenThrough::farFrom(std::max(by_first.distance, by_second.distance));
  return std::max(by_first.aside, by_second.aside) > kShowsBeyond * far;
}

}  // namespace

std::vector<ApartSpan> withoutRefuted(std::vector<ApartSpan> spans, std::span<const SeenTwice> seen,
                                      std::span<const ThroughAt> through, const DepthCamera& first,
                                      const DepthCamera& second) {
  std::erase_if(spans, [&](const ApartSpan& span) {
    const std::vector<SeenTwice> bodies = during(span, seen);
    std::vector<double> shares;
    for (const ThroughAt& one : during(span, through))
      if (!std::isnan(one.share)) shares.push_back(one.share);
    const auto show = std::count_if(bodies.begin(), bodies.end(),
                                    [&](const SeenTwice& one) { return wouldShow(one, first, second); });
    const bool is_known = static_cast<double>(shares.size()) >= kKnown * static_cast<double>(bodies.size());
    return !shares.empty() && is_known && 2 * static_cast<std::size_t>(show) > bodies.size() &&
           nearestQuantile(shares, 0.5) < kNothingThrough;
  });
  return spans;
}

}  // namespace abstand::tracking
