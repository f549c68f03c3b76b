// Chronological list of events at a margin.
#pragma once

#include <string>
#include <vector>

#include "app/tune/part_frames.hpp"

namespace abstand::tune {

/// A stretch in which a part was nearer than the margin, or a contact that no margin would have detected.
struct MarginEvent {
  enum class Kind : std::uint8_t {
    kIntrusion,      ///< a stop is commanded at its first frame
    kBetweenFrames,  ///< the limit was reached between two frames outside of the margin
  };
  Kind kind{Kind::kIntrusion};
  const TunedRecording* recording{nullptr};
  std::uint16_t part{0}, link{0};  ///< indices in PassResult; the nearest link
  double t0{0.0}, t1{0.0};         ///< s; of the stretch, or of the two frames
  double t_nearest{0.0};           ///< s, of the frame with the smallest clearance
  double min_clearance{0.0};       ///< m, certified, if the robot had not stopped
  double braking{0.0};             ///< m, certified, until the robot is at rest
  bool false_stop{false}, missed{false};
  std::optional<double> lead_time;  ///< s
  /// Of an intrusion: the pair whose margin stopped the robot, of several the one farthest inside, and that
  /// margin (m, at the speeds of the moment).
  std::uint16_t told_part{0}, told_link{0};
  double told_margin{0.0};
  /// Of that pair in the first frame: m, certified; m/s, towards each other.
  double told_clearance{0.0}, told_robot_speed{0.0}, told_person_speed{0.0};
};

/// In order of time, then of parts. `part`: only this one; empty: all. The recording must outlive the events.
std::vector<MarginEvent> marginEvents(const TunedRecording& recording, double margin,
                                      const margin::MarginOptions& options, const std::string& part = {});
/// The same with the frames of the recording, for several questions about it.
std::vector<MarginEvent> marginEvents(const TunedRecording& recording, const PartFrames& frames,
                                      double margin, const margin::MarginOptions& options,
                                      const std::string& part = {});

/// At the limit between frame `index` of the part and the next one.
MarginEvent betweenFramesEvent(const TunedRecording& recording, const PartFrames& frames, std::size_t part,
                               std::size_t index);

}  // namespace abstand::tune
