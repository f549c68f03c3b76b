#include "core/margin/clearance_track.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.hpp"

namespace abstand::margin {

void validate(const ClearanceTrack& track) {
  const std::size_t n = track.frames();
  if (track.clearance.size() != n || track.between.size() != n || track.braking.size() != n)
    throw UsageError(
        "found a clearance track whose lists have different lengths, expected one entry per frame");
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(track.t[i]) || (i > 0 && !(track.t[i] > track.t[i - 1])))
      throw UsageError("found frame " + std::to_string(i) +
                       " of a clearance track at a time that does not rise");
    if (std::isnan(track.clearance[i]) || std::isnan(track.between[i]) || std::isnan(track.braking[i]))
      throw UsageError("found no number in frame " + std::to_string(i) +
                       " of a clearance track, expected one");
  }
}

void takeLeast(const ClearanceTrack& track, ClearanceTrack& least) {
  if (track.t != least.t) throw UsageError("found clearance tracks with different times, expected the same");
  const auto take = [](std::vector<double>& into, const std::vector<double>& from) {
    for (std::size_t i = 0; i < into.size(); ++i) into[i] = std::min(into[i], from[i]);
  };
  take(least.clearance, track.clearance);
  take(least.between, track.between);
  take(least.braking, track.braking);
}

ClearanceTrack leastOf(std::span<const ClearanceTrack* const> tracks) {
  if (tracks.empty()) throw UsageError("found no clearance track, expected one or more");
  ClearanceTrack least = *tracks.front();
  for (const ClearanceTrack* track : tracks.subspan(1)) takeLeast(*track, least);
  return least;
}

}  // namespace abstand::margin
