// The highest speed of each stretch of a robot's program.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// What has to hold of a robot that moves towards a person. kBoth: neither the protective distance nor the
/// limits of a contact would have been broken. kSeparation: the protective distance alone (speed and
/// separation monitoring). kContact: the limits of contacts alone (power and force limiting), but of parts at
/// which contact is excluded, the head, the protective distance: no speed of contact is allowed there.
enum class SpeedRule : std::uint8_t { kBoth, kSeparation, kContact };

/// What limits a speed.
enum class SpeedLimit : std::uint8_t { kSeparation, kContact };

/// The share that the rule permits of one that separation and one that contacts permit.
double permittedScale(SpeedRule rule, double by_separation, double by_contact);

/// A stretch of the program, the same times in every recording.
struct SpeedSegment {
  double t0{0.0}, t1{0.0};  ///< s
  double speed_scale{1.0};  ///< of the recorded speed; 0: the robot would have had to stand
  /// What limits it; none at 1.
  struct Limit {
    std::size_t recording{0};  ///< index
    double t{0.0};
    std::string part;
    SpeedLimit kind{SpeedLimit::kSeparation};
  };
  std::optional<Limit> limited_by;
  /// What each would have permitted by itself.
  double by_separation{1.0}, by_contact{1.0};
};

/// Of each stretch of `length` s the smallest speed scale of all recordings and parts (PartSeparation,
/// PartClearance::contact_scale): robots that are slowed down evenly over a stretch keep the rule beside
/// people who do as recorded, at the same places of the program. That slower robots meet people elsewhere is
/// not in it; proveSpeeds() replays that.
std::vector<SpeedSegment> speedTable(const std::vector<TunedRecording>& recordings, double length,
                                     SpeedRule rule = SpeedRule::kBoth);

/// s, of the program with these speeds; infinite where it has to stand.
double cycleTime(const std::vector<SpeedSegment>& segments);

}  // namespace abstand::tune
