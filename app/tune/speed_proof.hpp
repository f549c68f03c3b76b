// A program at its permitted speeds, replayed to prove itself.
#pragma once

#include "app/tune/program_replay.hpp"
#include "app/tune/speed_table.hpp"

namespace abstand::tune {

struct ProofOptions {
  SpeedRule rule{SpeedRule::kBoth};
  double deceleration{5.0};  ///< rad/s^2 or m/s^2, of changes of pace
  int max_iterations{10};
};

/// The share of its recorded speed below which a robot counts as standing: there is no program for it.
inline constexpr double kSlowestScale = 0.01;

/// What the last replay showed.
struct SpeedProof {
  /// Every recording was replayed beside the whole program and the rule was kept in every frame.
  bool proven{false};
  bool interrupted{false};
  int iterations{0};  ///< replays
  /// s, over all replays of the last iteration, in which the protective distance of some part was broken.
  double broken_time_separation{0.0};
  /// Stretches of frames of a part, in the same, in which a contact would have been above its limits, or
  /// where contact is excluded, the protective distance was broken.
  long broken_contacts{0};
  std::vector<FailedRun> failed;
  std::vector<PermittedPace> scales;  ///< of the stretches, in that iteration
  /// Why no slower program would do: a stretch in which the robot would have to stand, and the moment that
  /// says so.
  struct Stands {
    double t0{0.0}, t1{0.0};  ///< s, of the program
    std::string recording, part;
    double t{0.0};  ///< s, of the recording
    SpeedLimit kind{SpeedLimit::kSeparation};
  };
  std::optional<Stands> stands;
  std::optional<ProgramPace> pace;  ///< of the last replay; none where the robot had to stand at once
};

/// Replays the program at the speeds of `table`. Slower robots meet people elsewhere: where the rule is
/// broken, the stretches that the robot was in are slowed down further, by the share that would have kept it
/// and a little more, until nothing is broken, a stretch would have to stand, or max_iterations. Speeds only
/// fall. Throws as ProgramReplay::run.
SpeedProof proveSpeeds(const std::vector<SpeedSegment>& table, const std::vector<TunedRecording>& recorded,
                       ProgramReplay& replay, const ProofOptions& options);

/// One point of the curve of margin, speed and time.
struct TradePoint {
  double speed_scale{1.0};
  double cycle_time{0.0};     ///< s
  double margin{0.0};         ///< m, the largest proposed one of all parts; infinite where none would do
  double stopped_share{0.0};  ///< with that margin for the whole body; NaN where none would do
  double unjudged{0.0};       ///< s at the beginnings of replays, all together (TunedRecording::unjudged)
  std::size_t failed{0};      ///< replays that could not be run
  bool interrupted{false};
};

/// The program slowed down evenly to each scale (positive, 1 at most), and the margins that it needs then.
std::vector<TradePoint> tradeCurve(const std::vector<double>& scales, ProgramReplay& replay,
                                   const TuneOptions& options);

}  // namespace abstand::tune
