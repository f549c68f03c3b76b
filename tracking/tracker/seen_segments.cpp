// Shares, support, chains of the arms.
#include "tracking/tracker/seen_segments.hpp"

#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {

SeenSegments seenSegments(const std::array<double, kRigSegments>& visible,
                          const std::array<double, kRigSegments>& support) {
  SeenSegments seen = 0;
  for (std::size_t s = 0; s < kRigSegments; ++s)
    if (visible[s] >= kSeenShare) seen |= 1u << s;
  for (const Limb& limb : kLimbs) {
    bool is_attached = true;
    for (const RigSegment segment : {limb.upper, limb.lower, limb.end}) {
      const bool is_supported = support[index(segment)] >= kSupported;
      if (!is_supported || !is_attached) seen &= ~(1u << index(segment));
      if (limb.isArm()) is_attached &= is_supported;
    }
  }
  return seen;
}

}  // namespace abstand::tracking
