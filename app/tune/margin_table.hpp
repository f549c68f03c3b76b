// Outcomes of margins over all recordings, and proposed margins.
#pragma once

#include "app/tune/recording_tune.hpp"
#include "core/margin/margin_confidence.hpp"
#include "core/margin/safe_margin.hpp"

namespace abstand::tune {

/// Row name for all parts with the same margin, besides the rows of single parts.
inline constexpr const char* kWholeBody = "whole_body";

struct MarginRow {
  std::string part;
  double margin{0.0};  ///< m
  margin::MarginOutcome outcome;
};

/// Smallest margin of a part without a missed stop in any recording.
struct ProposedMargin {
  std::string part;
  double margin{0.0};  ///< m, rounded up to whole millimetres; infinite if none suffices
  /// The decisive stop; empty if no margin is needed in the recordings.
  struct Decision {
    std::size_t recording{0};  ///< index
    double t{0.0};             ///< s, time of the stop command
    std::string link;
    std::string tool;       ///< name of the tool in the hand that is nearer than the hand; else empty
    double clearance{0.0};  ///< m, one frame earlier
    /// m, contributions to the margin: the engine's bound, pose uncertainty, and motion within one frame.
    double bound{0.0}, pose{0.0}, sampling{0.0};
  };
  std::optional<Decision> decided_by;
  double unseen_share{1.0};  ///< margin::unseenShare for the number of recordings
  /// s, in which the part was judged; runs of one recording count once, with the longest of them.
  double judged_time{0.0};
  std::vector<double> needed;            ///< m, of each recording in order
  std::optional<margin::GumbelFit> fit;  ///< of `needed`
};

using margin::roundedUpMargin;

struct MarginTable {
  std::vector<MarginRow> rows;  ///< part by part, margins increasing
  std::vector<ProposedMargin> proposed;
};

/// s, judged time of the part that was judged for the shortest time.
double shortestJudgedTime(const MarginTable& table);

/// `margins`: m, increasing.
MarginTable marginTable(const std::vector<TunedRecording>& recordings, const std::vector<double>& margins,
                        const TuneOptions& options);

}  // namespace abstand::tune
