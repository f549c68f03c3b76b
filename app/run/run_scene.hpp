// Runs a scene over its motion and summarises it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/loop/loop_report.hpp"
#include "app/run/csv_outputs.hpp"
#include "app/run/cycle_profile.hpp"
#include "app/run/joint_limits.hpp"
#include "app/run/live_loop.hpp"
#include "app/run/pair_class.hpp"
#include "app/run/reservations.hpp"
#include "app/session/session.hpp"

namespace abstand::run {

enum class RunMode { kLockstep, kLive };

struct RunOptions {
  std::optional<double> start, end;  ///< s
  std::optional<double> rate;        ///< Hz; without: the frames of the recording
  RunMode mode{RunMode::kLockstep};
  LivePace pace{LivePace::kRealTime};  ///< in live mode
  /// Mechanisms with a `reaction` react: the closed loop runs one cycle for each millisecond, and frames are
  /// the cycles at their times. In live mode they react to the newest results, at least one cycle old. If
  /// false, they follow their motion like all others.
  bool react{false};
  int repeat{1};
  bool profile{false};  ///< profile the cycles of lock step and of the closed loop; doubles the run time
  CsvPaths csv;
  std::filesystem::path session_log;  ///< HDF5; empty: none
  std::string program;                ///< version of the program, for the session log
  std::function<void(std::size_t done, std::size_t all)> progress;
  std::function<bool()> interrupted;  ///< polled in each frame
  /// False: the summary has no extremes of distances, forces and contacts, and no slowest pair.
  bool extremes{true};
  /// Called for each frame, in the closed loop for each cycle, with the results in scene order; in the last
  /// repeat only.
  std::function<void(double t, const std::vector<query::PairResult>&)> on_cycle;
};

/// A pass starts cold at frame 0 and every kColdStart frames, so that a pass beginning at one of these gives
/// the same bits as the whole.
inline constexpr std::size_t kColdStart = 128;

struct RunSummary {
  struct Extreme {
    std::string a, b;
    double t{0.0}, value{0.0};
  };
  std::size_t frames{0}, objects{0}, pairs{0};
  /// Cycle times, microseconds.
  struct CycleTimes {
    double median{0.0}, p99{0.0}, p999{0.0}, max{0.0};
    long overruns{0};  ///< cycles longer than kPeriodUs
  } cycle_us;
  std::optional<Extreme> min_distance;
  std::array<std::optional<Extreme>, kPairClasses.size()>
      min_distance_by_class;  ///< in the order of kPairClasses
  /// Smallest distance minus the pose uncertainty of both bodies; -infinity if a body was not seen at all.
  std::optional<Extreme> min_clearance;
  std::optional<Extreme> peak_force;  ///< N, largest force of a pair
  bool peak_force_apart{false};       ///< the surfaces did not touch then: the force is due to margins only
  /// s, live mode: largest age of a pair's result when collected; infinite: a result was missing.
  std::optional<Extreme> oldest_result;
  long contacts{0};                       ///< pairs in contact, summed over all frames, or cycles of the loop
  std::optional<Extreme> slowest_pair;    ///< value: mean query time in microseconds
  std::vector<std::string> stale;         ///< objects that were stale or rejected at some time
  std::vector<Reservation> reservations;  ///< reasons to doubt the results
  /// Warm start of queries (QueryCulling::remember).
  struct WarmStart {
    std::size_t block{0};  ///< frames between cold starts; 0: cold only at the start
    double far_tolerance{0.0};
  };
  std::optional<WarmStart> warm_start;
  /// Outcomes of pairs, over all frames of all repeats.
  struct Work {
    long checked{0}, rested{0}, beyond{0}, deferred{0};
    int longest_wait{0};  ///< cycles, of a deferred pair
  } work;
  /// Stretches in which an object exceeded its max_speed.
  struct SpeedBreaches {
    struct Breach {
      std::string object;
      double t{0.0}, speed{0.0}, bound{0.0};
    };
    std::vector<Breach> listed;  ///< the first ones
    long count{0};               ///< total number
  } breaches;
  long cycles{0};                              ///< of the closed loop; 0: none
  std::vector<loop::ReactionReport> robots;    ///< reacting robots
  std::vector<JointLimitReport> joint_limits;  ///< violated position, velocity, acceleration and effort
                                               ///< limits
  std::optional<CycleProfile> profile;
  double build_ms{0.0};
  std::size_t memory_bytes{0};
  bool interrupted{false};
  static constexpr double kPeriodUs = 1000.0;
};

/// Throws UsageError for a time range without a frame and for files that cannot be written; ParseError for a
/// robot that cannot react.
RunSummary runScene(session::Session& session, const RunOptions& options);

}  // namespace abstand::run
