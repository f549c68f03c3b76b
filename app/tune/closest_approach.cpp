#include "app/tune/closest_approach.hpp"

#include <algorithm>
#include <cmath>

#include "app/tune/part_frames.hpp"

namespace abstand::tune {
namespace {

/// Updates `closest` from the frames of a part in recording `index`.
void takeFrames(const TunedRecording& recording, std::size_t index, const PartClearance& part,
                double calibration, ClosestApproach& closest) {
  const margin::ClearanceTrack& track = part.track;
  for (std::size_t i = 0; i < track.frames(); ++i) {
    if (std::isinf(part.uncertainty[i])) {
      closest.always_seen = false;
      closest.not_seen += i + 1 < track.frames() ? track.t[i + 1] - track.t[i] : 0.0;
      continue;
    }
    const double least = std::min(track.clearance[i], track.between[i]);
    if (!(least < closest.clearance())) continue;
    closest.recording = index;
    closest.t = track.t[i];
    closest.link = recording.pass.links[part.link[i]];
    closest.tool = recording.pass.toolName(part.tool[i]);
    closest.distance = part.distance[i];
    closest.bound = part.bound[i];
    closest.calibration = calibration;
    closest.latency = part.latency_uncertainty[i];
    closest.pose = std::max(0.0, part.uncertainty[i] - calibration - closest.latency);
    closest.pose_age = std::min(part.age_uncertainty[i], closest.pose);
    // Between frames another link may be nearer; this contribution is the rest of the difference.
    closest.between_frames = 0.0;
    closest.between_frames = std::max(0.0, closest.clearance() - least);
  }
}

}  // namespace

ClosestApproach::Verdict ClosestApproach::verdict() const {
  if (!(clearance() > 0.0)) return Verdict::kTouchPossible;
  return always_seen ? Verdict::kApart : Verdict::kNotKnown;
}

const char* verdictText(ClosestApproach::Verdict verdict) {
  switch (verdict) {
    case ClosestApproach::Verdict::kApart:
      return "certified apart";
    case ClosestApproach::Verdict::kTouchPossible:
      return "contact possible";
    case ClosestApproach::Verdict::kNotKnown:
      return "unknown while not tracked";
  }
  return "";
}

const char* verdictName(ClosestApproach::Verdict verdict) {
  switch (verdict) {
    case ClosestApproach::Verdict::kApart:
      return "certainly apart";
    case ClosestApproach::Verdict::kTouchPossible:
      return "touch not excluded";
    case ClosestApproach::Verdict::kNotKnown:
      return "not known where not seen";
  }
  return "";
}

std::vector<ClosestApproach> closestApproaches(const std::vector<TunedRecording>& recordings,
                                               double calibration) {
  std::vector<ClosestApproach> all;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    PartByPart parts(recordings[r]);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const PartClearance& part = parts.part(p);
      auto found =
          std::find_if(all.begin(), all.end(), [&](const ClosestApproach& c) { return c.part == part.part; });
      if (found == all.end()) {
        found = all.insert(all.end(), ClosestApproach{});
        found->part = part.part;
      }
      takeFrames(recordings[r], r, part, calibration, *found);
    }
  }
  return all;
}

}  // namespace abstand::tune
