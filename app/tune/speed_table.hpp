// Highest permitted speed of each segment of a robot's program.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// Rule for a robot that moves towards a person. kBoth: neither the protective distance nor the contact
/// limits may be violated. kSeparation: only the protective distance (speed and separation monitoring).
/// kContact: only the contact limits (power and force limiting), but for parts at which contact is excluded,
/// the head, the protective distance: no contact speed is allowed there.
enum class SpeedRule : std::uint8_t { kBoth, kSeparation, kContact };

/// What limits a speed.
enum class SpeedLimit : std::uint8_t { kSeparation, kContact };

/// The pace that the rule permits, from those by separation and by contact.
double permittedScale(SpeedRule rule, double by_separation, double by_contact);

/// A program segment, at the same times in every recording.
struct SpeedSegment {
  double t0{0.0}, t1{0.0};  ///< s
  double speed_scale{1.0};  ///< of the recorded speed; 0: the robot would have to stand
  /// Cause of the limit; empty at 1.
  struct Limit {
    std::size_t recording{0};  ///< index
    double t{0.0};
    std::string part;
    SpeedLimit kind{SpeedLimit::kSeparation};
  };
  std::optional<Limit> limited_by;
  /// Pace permitted by each criterion alone.
  double by_separation{1.0}, by_contact{1.0};
};

/// For each segment of `length` s the smallest speed scale of all recordings and parts (PartSeparation,
/// PartClearance::contact_scale): robots slowed down uniformly within a segment keep the rule if people do as
/// recorded at the same places of the program. Does not consider that slower robots meet people elsewhere;
/// proveSpeeds() does, by replay.
std::vector<SpeedSegment> speedTable(const std::vector<TunedRecording>& recordings, double length,
                                     SpeedRule rule = SpeedRule::kBoth);

/// Duration (s) of the program at these speeds; infinite if it has to stand.
double cycleTime(const std::vector<SpeedSegment>& segments);

}  // namespace abstand::tune
