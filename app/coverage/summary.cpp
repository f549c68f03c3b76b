#include "app/coverage/summary.hpp"

#include <algorithm>

namespace abstand::coverage {

const HiddenSpan* PartSummary::longest() const {
  const auto found =
      std::max_element(spans.begin(), spans.end(),
                       [](const HiddenSpan& a, const HiddenSpan& b) { return a.t1 - a.t0 < b.t1 - b.t0; });
  return found == spans.end() ? nullptr : &*found;
}

bool isSeen(const Shares& shares) { return shareOf(shares, Cause::kSeen) >= kSeenShare; }

Cause mainCause(const Shares& shares) {
  static_assert(static_cast<std::size_t>(Cause::kSeen) == 0);
  return static_cast<Cause>(std::max_element(shares.begin() + 1, shares.end()) - shares.begin());
}

PartSummary summarize(std::span<const double> times, std::span<const Shares> shares) {
  std::array<double, kCauses> at{}, surface{};
  PartSummary summary;
  Shares in_span{};
  bool hidden = false;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    for (std::size_t k = 0; k < kCauses; ++k) surface[k] += shares[i][k];
    const bool seen = isSeen(shares[i]);
    at[static_cast<std::size_t>(seen ? Cause::kSeen : mainCause(shares[i]))] += 1.0;
    if (!seen && !hidden) {
      summary.spans.push_back({times[i], times[i], Cause::kUnknown});
      in_span = {};
    }
    if (!seen || hidden) summary.spans.back().t1 = times[i];
    if (!seen) {
      for (std::size_t k = 0; k < kCauses; ++k) in_span[k] += shares[i][k];
      summary.spans.back().cause = mainCause(in_span);
    }
    hidden = !seen;
  }
  for (std::size_t k = 0; k < kCauses && !shares.empty(); ++k) {
    summary.times[k] = static_cast<float>(at[k] / static_cast<double>(shares.size()));
    summary.surface[k] = static_cast<float>(surface[k] / static_cast<double>(shares.size()));
  }
  return summary;
}

}  // namespace abstand::coverage
