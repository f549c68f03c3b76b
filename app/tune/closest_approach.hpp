// Closest approach of each body part, and its certainty.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// For one part over all recordings: the time of the smallest certified clearance, at and between the frames.
/// `distance` is the measured one; the true distance is at least `distance` - error().
struct ClosestApproach {
  std::string part;
  std::size_t recording{0};  ///< index
  double t{0.0};             ///< s; between two frames, that of the first one
  std::string link;
  std::string tool;            ///< name of the tool in the hand that is nearer than the hand; else empty
  double distance{kInfinity};  ///< m
  /// m, contributions to the error: the engine's bound, uncertainty of the person's pose (tracking, gaps),
  /// latency of the pose (latency.hpp), calibration between recording and robot, and possible approach
  /// between two frames.
  double bound{0.0}, pose{0.0}, latency{0.0}, calibration{0.0}, between_frames{0.0};
  double pose_age{
      0.0};  ///< m, the share of `pose` due to the age of the pose: the part was not seen recently
  double not_seen{0.0};    ///< s, over all recordings, in which the part was not seen
  bool always_seen{true};  ///< in every frame of every recording

  /// m, the share of `pose` that the tracker states.
  double poseTracker() const { return pose - pose_age; }
  double error() const { return bound + pose + latency + calibration + between_frames; }
  /// Certified clearance (m).
  double clearance() const { return distance - error(); }
  enum class Verdict : std::uint8_t { kApart, kTouchPossible, kNotKnown };
  /// Unknown if the part was not always seen, and stayed apart where it was.
  Verdict verdict() const;
};

/// Text for people: "certified apart", "contact possible", "unknown while not tracked".
const char* verdictText(ClosestApproach::Verdict verdict);
/// Value of the JSON key `verdict`, which does not change: "certainly apart", "touch not excluded", "not
/// known where not seen".
const char* verdictName(ClosestApproach::Verdict verdict);

/// Results for all parts, in the order of the body. `calibration`: m, its share of every uncertainty
/// (TuneOptions).
std::vector<ClosestApproach> closestApproaches(const std::vector<TunedRecording>& recordings,
                                               double calibration);

}  // namespace abstand::tune
