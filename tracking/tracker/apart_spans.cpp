#include "tracking/tracker/apart_spans.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/quantile.hpp"
#include "tracking/tracker/middle_joints.hpp"
#include "tracking/tracker/span_collector.hpp"

namespace abstand::tracking {
namespace {

// s: the time of a push is known to two images, and three images after it a body is found at its new place.
// The shorter the times are, the less people accelerate in them.
constexpr double kJumpSettles = 0.1, kBeforeJump = 0.07, kLongBeforeJump = 0.2;
// Shares of the jump: of the camera that was pushed, at least; of the other one, at most.
constexpr double kOfPushed = 0.6, kOfUnmoved = 0.4;

// m: bodies tracked with one camera at 13 Hz, the legs behind a bench, were up to 0.09 too high or too low.
constexpr double kVerticalError = 0.10;

/// m, what a fit with one camera does not explain.
double unexplained(const Vector3d& off) {
  return std::hypot(off.x(), off.y(), std::max(0.0, std::abs(off.z()) - kVerticalError));
}

Vector3d medianOffset(std::span<const SeenTwice> seen) {
  Vector3d median;
  for (Eigen::Index a = 0; a < 3; ++a) {
    std::vector<double> values;
    for (const SeenTwice& one : seen) values.push_back(one.off[a]);
    median[a] = nearestQuantile(values, 0.5);
  }
  return median;
}

/// The last one until `t`, if it is not much older.
const SeenTwice* lastSeenUntil(std::span<const SeenTwice> seen, double t) {
  const auto after = std::upper_bound(seen.begin(), seen.end(), t,
                                      [](double time, const SeenTwice& one) { return time < one.t; });
  if (after == seen.begin() || t - std::prev(after)->t > kJumpSettles) return nullptr;
  return &*std::prev(after);
}

}  // namespace

std::vector<ApartSpan> apartSpans(std::span<const SeenTwice> seen) {
  SpanCollector spans;
  forEachWindow(seen, [&](const SeenTwice& one, std::span<const SeenTwice> window) {
    const Vector3d off = medianOffset(window);
    spans.add(one.t, unexplained(off) > ApartSpan::kApart, off.norm());
  });
  return spans.finish();
}

std::optional<int> whichJumped(std::span<const SeenTwice> seen, double t) {
  const SeenTwice *before = lastSeenUntil(seen, t - kLongBeforeJump),
                  *at = lastSeenUntil(seen, t - kBeforeJump), *after = lastSeenUntil(seen, t + kJumpSettles);
  if (!before || !at || !after || before == at || at == after) return std::nullopt;
  const double jump = (after->off - at->off).norm();
  if (jump < ApartSpan::kApart) return std::nullopt;
  const double times = (after->t - at->t) / (at->t - before->t);
  std::array<double, 2> beside{};  // m, from where the body would be
  for (std::size_t k = 0; k < 2; ++k) {
    const auto of = [k](const SeenTwice* one) -> const humanmodel::SkeletonFrame& {
      return k == 0 ? one->first : one->second;
    };
    const auto moved = offsetBetween(of(before), of(at)), jumped = offsetBetween(of(at), of(after));
    if (!moved || !jumped) return std::nullopt;
    beside[k] = (*jumped - times * *moved).norm();
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (beside[k] > kOfPushed * jump && beside[1 - k] < kOfUnmoved * jump) return static_cast<int>(k);
  return std::nullopt;
}

}  // namespace abstand::tracking
