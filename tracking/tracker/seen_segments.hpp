// Which segments an image shows.
#pragma once

#include "tracking/tracker/hidden_spread.hpp"

namespace abstand::tracking {

/// A segment is seen if `visible`, the share of its samples that a camera sees (DepthFit::visibility()), is
/// at least kSeenShare, and one of a limb only if it explains points that no other one does (`support`,
/// DepthFit::support()): else it may have been put in front of the trunk because it has to be somewhere. What
/// lies beyond an upper arm or a forearm without support is not seen either: what explains points there may
/// be another limb.
SeenSegments seenSegments(const std::array<double, kRigSegments>& visible,
                          const std::array<double, kRigSegments>& support);

inline constexpr double kSeenShare = 0.3;
inline constexpr double kSupported = 0.5;  ///< points

}  // namespace abstand::tracking
