// Verifies a program at its permitted speeds by replay.
#pragma once

#include "app/tune/program_replay.hpp"
#include "app/tune/speed_table.hpp"

namespace abstand::tune {

struct ProofOptions {
  SpeedRule rule{SpeedRule::kBoth};
  double deceleration{5.0};  ///< rad/s^2 or m/s^2, for changes of pace
  int max_iterations{10};
};

/// Smallest pace; a slower robot counts as standing, for which there is no program.
inline constexpr double kSlowestScale = 0.01;

/// Result of the last replay.
struct SpeedProof {
  /// Every recording was replayed with the whole program and the rule was kept in every frame.
  bool proven{false};
  bool interrupted{false};
  int iterations{0};  ///< replays
  /// s, over all replays of the last iteration: time with a violated protective distance of some part.
  double broken_time_separation{0.0};
  /// Number of stretches of frames of a part, in the last iteration, with a predicted contact above its
  /// limits or, if contact is excluded, a violated protective distance.
  long broken_contacts{0};
  std::vector<FailedRun> failed;
  std::vector<PermittedPace> scales;  ///< of the program segments, in that iteration
  /// Reason why no slower program suffices: a segment in which the robot would have to stand, and the
  /// decisive time.
  struct Stands {
    double t0{0.0}, t1{0.0};  ///< s, of the program
    std::string recording, part;
    double t{0.0};  ///< s, recording time
    SpeedLimit kind{SpeedLimit::kSeparation};
  };
  std::optional<Stands> stands;
  std::optional<ProgramPace> pace;  ///< of the last replay; empty if the robot had to stand from the start
};

/// Replays the program at the speeds of `table`. A slower robot meets people at other places: where the rule
/// is violated, the affected segments are slowed down further, by the share that would have kept it and a
/// little more, until there is no violation, a segment would have to stand, or max_iterations is reached.
/// Speeds only decrease. Throws as ProgramReplay::run.
SpeedProof proveSpeeds(const std::vector<SpeedSegment>& table, const std::vector<TunedRecording>& recorded,
                       ProgramReplay& replay, const ProofOptions& options);

/// One point of the trade-off between margin, speed and time.
struct TradePoint {
  double speed_scale{1.0};
  double cycle_time{0.0};     ///< s
  double margin{0.0};         ///< m, largest proposed one of all parts; infinite if none suffices
  double stopped_share{0.0};  ///< with that margin for the whole body; NaN if none suffices
  double unjudged{0.0};       ///< s at the beginnings of all replays (TunedRecording::unjudged)
  std::size_t failed{0};      ///< failed replays
  bool interrupted{false};
};

/// The program at each constant pace (positive, at most 1), and the margins needed then.
std::vector<TradePoint> tradeCurve(const std::vector<double>& scales, ProgramReplay& replay,
                                   const TuneOptions& options);

}  // namespace abstand::tune
