// Speed and separation monitoring over a recording: was the protective distance kept, and at which speed
// would it be.
#pragma once

#include <optional>
#include <vector>

#include "core/safety/protective_distance.hpp"

namespace abstand::tune {

/// The moment at which most of a part's protective distance was missing.
struct SeparationMoment {
  double t{0.0};
  std::uint16_t link{0};                       ///< index into PassResult::links
  double clearance{0.0};                       ///< m, certified
  double robot_speed{0.0}, person_speed{0.0};  ///< m/s, towards each other
  safety::ProtectiveDistance needed;           ///< its terms: which one bought a stop
  double permitted_speed{0.0};                 ///< m/s, of the robot at this clearance
};

/// Of one part. Lists have one entry a frame and take the worst link.
struct PartSeparation {
  /// m: protective distance less clearance; above 0 it was broken. -infinity where no link moves towards the
  /// part.
  std::vector<double> missing;
  /// 0 to 1: share of the recorded speed at which it would have been kept.
  std::vector<double> speed_scale;
  std::optional<SeparationMoment> worst;  ///< none where it was kept throughout
};

/// Takes one pair at one frame into the last entries of `part`, which exist. `clearance` has the uncertainty
/// of the person's pose in it already, so options.person_error is for what else is not known. Pairs whose
/// link does not move towards the part say nothing.
void takeSeparation(PartSeparation& part, const SeparationMoment& moment,
                    const safety::SeparationOptions& options);

}  // namespace abstand::tune
