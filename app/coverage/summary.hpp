// For how long a part is hidden, and by what.
#pragma once

#include <span>
#include <vector>

#include "app/coverage/coverage.hpp"
#include "tracking/tracker/seen_segments.hpp"

namespace abstand::coverage {

/// A part counts as seen at a time if this share of its camera-facing surface is seen: the share that the
/// tracker requires of tracked joints.
inline constexpr double kSeenShare = tracking::kSeenShare;

struct HiddenSpan {
  double t0{0.0}, t1{0.0};       ///< s: the first time hidden, the next time seen or the last one of all
  Cause cause{Cause::kUnknown};  ///< of the largest hidden share, summed over the span
};

struct PartSummary {
  /// Shares of the times: kSeen, and the others by the cause of the largest hidden share.
  Shares times{};
  Shares surface{};  ///< means of the shares of the surface
  std::vector<HiddenSpan> spans;
  /// The longest, the first of equal ones; null: always seen. Valid as long as `spans`.
  const HiddenSpan* longest() const;
};

bool isSeen(const Shares& shares);
/// Of the largest hidden share, the first of equal ones.
Cause mainCause(const Shares& shares);

/// Each time stands for the time until the next one. `shares`: one for each of `times`.
PartSummary summarize(std::span<const double> times, std::span<const Shares> shares);

}  // namespace abstand::coverage
