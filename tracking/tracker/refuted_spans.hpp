// Disagreements of two cameras that their silhouettes refute.
#pragma once

#include <span>
#include <vector>

#include "tracking/tracker/apart_spans.hpp"
#include "tracking/tracker/through_spans.hpp"

namespace abstand::tracking {

/// Median share seen through below which nothing is, and times SeenThrough::farFrom() that a camera is aside
/// from which on more than that would be.
inline constexpr double kNothingThrough = 0.25 * ThroughAt::kShare, kShowsBeyond = 1.5;

/// The spans without those that only come from bodies fitted wrongly, as of people near to one camera or cut
/// off by its image. A camera that is off sees through people whom the other one measures (SeenThrough),
/// unless the displacement is along the rays of both or within the noise: where hardly anything is seen
/// through although a displacement of this size would be, the cameras are right. `seen`, `through`: what the
/// spans were found with, by increasing time. May allocate.
std::vector<ApartSpan> withoutRefuted(std::vector<ApartSpan> spans, std::span<const SeenTwice> seen,
                                      std::span<const ThroughAt> through, const DepthCamera& first,
                                      const DepthCamera& second);

}  // namespace abstand::tracking
