// What `tune` and `merge` answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/tune/closest_approach.hpp"
#include "app/tune/exposure_table.hpp"
#include "app/tune/margin_strategy.hpp"
#include "app/tune/speed_proof.hpp"
#include "app/tune/study.hpp"
#include "app/tune/variant_band.hpp"
#include "app/tune/worst_phase.hpp"

namespace abstand::tune {

struct TuneAnswer {
  TuneOptions options;
  std::vector<TunedRecording> recordings;
  std::vector<FailedRun> failed;
  std::optional<std::size_t> made, kept;  ///< result files, where there are any
  MarginTable table;
  std::vector<GroupNeed> links, pairs;  ///< smallest safe margins
  std::vector<ClosestApproach> closest;
  std::vector<VariantBand> bands;
  std::vector<StrategyOutcome> strategies;  ///< of the proposed sets of margins, and of those asked for
  std::vector<SpeedSegment> speeds;
  ExposureTable exposure;
  SpeedRule speed_rule{SpeedRule::kBoth};  ///< of `speeds` and `proof`
  std::optional<SpeedProof> proof;         ///< where a speed profile was asked for
  /// The program that it slows down, and the file that each motion went to; empty: it is not proven.
  struct ProfileMotion {
    std::string mechanism;
    std::filesystem::path file;
  };
  std::vector<ProfileMotion> profile;
  std::vector<TradePoint> trade;
  /// Where it was asked for: of each recording.
  struct RecordingPhases {
    std::string recording;
    std::vector<WorstPhase> parts;
  };
  std::vector<RecordingPhases> worst_phases;
  bool interrupted{false};
};

/// What is asked of recordings after their pass.
struct TuneQuestions {
  std::vector<double> margins;  ///< m, rising
  double segment{1.0};          ///< s
  std::vector<MarginRules> margin_sets;
  SpeedRule speed_rule{SpeedRule::kBoth};
};

/// Makes the tables of the answer from its recordings, which have result files. Throws as strategyOutcomes().
void answerQuestions(const TuneQuestions& questions, TuneAnswer& answer);

/// What mergeResults() finds, with the options of the results; tables are still to be made. Throws likewise.
TuneAnswer mergedAnswer(const std::vector<std::filesystem::path>& folders);

/// The approaches of all recordings, nearest first.
struct RankedApproach {
  const TunedRecording* recording;
  const Approach* approach;
};
std::vector<RankedApproach> rankedApproaches(const TuneAnswer& answer);

}  // namespace abstand::tune
