// How near each body part came, and how certain that is.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// Of a part over all recordings: the moment with the least certified clearance, at the frames and between
/// them. `distance` is what was measured then; the true distance is at least `distance` - error().
struct ClosestApproach {
  std::string part;
  std::size_t recording{0};  ///< index
  double t{0.0};             ///< s; where it is between two frames, of the first one
  std::string link;
  double distance{kInfinity};  ///< m
  /// m, each share of the error: the engine's bound, what is not known of the person's pose (tracking, gaps),
  /// the calibration between recording and robot, and how far the bodies may have come nearer between two
  /// frames.
  double bound{0.0}, pose{0.0}, calibration{0.0}, between_frames{0.0};
  double not_seen{0.0};    ///< s, over all recordings, in which nothing is known of the part
  bool always_seen{true};  ///< in every frame of every recording

  double error() const { return bound + pose + calibration + between_frames; }
  /// m, certified.
  double clearance() const { return distance - error(); }
  enum class Verdict : std::uint8_t { kApart, kTouchPossible, kNotKnown };
  /// Not known: somewhere the part was not seen, and where it was it stayed apart.
  Verdict verdict() const;
};

/// "certainly apart", "touch not excluded", "not known where not seen".
const char* verdictText(ClosestApproach::Verdict verdict);

/// Parts in the order of the body. `calibration`: m, TuneOptions' share of every uncertainty.
std::vector<ClosestApproach> closestApproaches(const std::vector<TunedRecording>& recordings,
                                               double calibration);

}  // namespace abstand::tune
