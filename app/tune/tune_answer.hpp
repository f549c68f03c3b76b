// Answers of `tune` and `merge`.
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
  std::optional<std::size_t> made, kept;  ///< numbers of result files, if any
  MarginTable table;
  std::vector<GroupNeed> links, pairs;  ///< smallest safe margins
  std::vector<ClosestApproach> closest;
  std::vector<VariantBand> bands;
  std::vector<StrategyOutcome> strategies;  ///< of the proposed sets of margins, and of the user's
  std::vector<SpeedSegment> speeds;
  ExposureTable exposure;
  SpeedRule speed_rule{SpeedRule::kBoth};  ///< of `speeds` and `proof`
  std::optional<SpeedProof> proof;         ///< if a speed profile was requested
  /// The program that it slows down, and the output file of each motion; empty: not proven.
  struct ProfileMotion {
    std::string mechanism;
    std::filesystem::path file;
  };
  std::vector<ProfileMotion> profile;
  std::vector<TradePoint> trade;
  /// If requested: worst phases of each recording.
  struct RecordingPhases {
    std::string recording;
    std::vector<WorstPhase> parts;
  };
  std::vector<RecordingPhases> worst_phases;
  bool interrupted{false};
};

/// Questions about recordings after their pass.
struct TuneQuestions {
  std::vector<double> margins;  ///< m, increasing
  double segment{1.0};          ///< s
  std::vector<MarginRules> margin_sets;
  SpeedRule speed_rule{SpeedRule::kBoth};
};

/// Computes the tables of the answer from its recordings, which have result files. Throws as
/// strategyOutcomes().
void answerQuestions(const TuneQuestions& questions, TuneAnswer& answer);

/// Results of mergeResults() with their options; without the tables. Throws likewise.
TuneAnswer mergedAnswer(const std::vector<std::filesystem::path>& folders);

/// Parts that may be clamped in any of the recordings, sorted.
std::vector<std::string> clampedParts(const std::vector<TunedRecording>& recordings);

/// Warm starts of the recording with the largest tolerance; empty: all frames were cold starts.
std::optional<run::RunSummary::WarmStart> warmStartOf(const std::vector<TunedRecording>& recordings);

/// Files of all recordings, each once.
std::vector<InputFile> inputFiles(const std::vector<TunedRecording>& recordings);

/// Smallest and largest share of people whose part `part` is enclosed by the model, over all recordings:
/// plans have several bodies. nullopt if no recording knows it.
struct EnclosedRange {
  humanmodel::EnclosedShare min, max;
};
std::optional<EnclosedRange> enclosedRange(const std::vector<TunedRecording>& recordings,
                                           const std::string& part);

/// Approaches of all recordings, nearest first.
struct RankedApproach {
  const TunedRecording* recording;
  const Approach* approach;
};
std::vector<RankedApproach> rankedApproaches(const TuneAnswer& answer);

}  // namespace abstand::tune
