// Speed and separation monitoring over a recording: whether the protective distance was kept, and at which
// speed it would have been.
#pragma once

#include <optional>
#include <vector>

#include "core/safety/protective_distance.hpp"

namespace abstand::tune {

/// The time with the largest shortfall of a part's protective distance.
struct SeparationMoment {
  double t{0.0};
  std::uint16_t link{0};                       ///< index in PassResult::links
  double clearance{0.0};                       ///< m, certified
  double robot_speed{0.0}, person_speed{0.0};  ///< m/s, towards each other
  safety::ProtectiveDistance needed;           ///< its terms: which one would cause a stop
  double permitted_speed{0.0};                 ///< m/s, of the robot at this clearance
  /// m: protective distance minus clearance; violated if above 0.
  double missing() const { return needed.sum() - clearance; }
};

/// `pair` (its time, link, clearance and speeds) with the terms of its protective distance and the permitted
/// speed; empty if the link does not move towards the part. `clearance` includes the person's pose
/// uncertainty, so options.person_error is for other errors.
std::optional<SeparationMoment> separationMoment(const SeparationMoment& pair,
                                                 const safety::SeparationOptions& options);

/// Results of one part. Lists have one entry for each frame, of the worst link.
struct PartSeparation {
  /// m: protective distance minus clearance; violated if above 0. -infinity if no link moves towards the
  /// part.
  std::vector<double> missing;
  /// 0 to 1: share of the recorded speed at which it would have been kept.
  std::vector<double> speed_scale;
  std::optional<SeparationMoment> worst;  ///< empty if it was always kept
  double broken{0.0};                     ///< s, from each frame with `missing` above 0 to the next one
};

/// Updates the last entries of `part`, which exist, with one pair in one frame, as separationMoment() judges
/// it.
void takeSeparation(PartSeparation& part, const SeparationMoment& moment,
                    const safety::SeparationOptions& options);

}  // namespace abstand::tune
