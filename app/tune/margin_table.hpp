// What margins would have done over all recordings, and which are proposed.
#pragma once

#include "app/tune/recording_tune.hpp"
#include "core/margin/margin_confidence.hpp"
#include "core/margin/safe_margin.hpp"

namespace abstand::tune {

/// Every part alone, and one row for all of them with the same margin.
inline constexpr const char* kWholeBody = "whole_body";

struct MarginRow {
  std::string part;
  double margin{0.0};  ///< m
  margin::MarginOutcome outcome;
};

/// The smallest margin of a part that would have missed no stop in any recording.
struct ProposedMargin {
  std::string part;
  double margin{0.0};  ///< m, rounded up to whole millimetres; infinite where none would do
  /// The stop that decides it; none where no margin is needed for what was recorded.
  struct Decision {
    std::size_t recording{0};  ///< index
    double t{0.0};             ///< s, when the stop was told
    std::string link;
    double clearance{0.0};  ///< m, one frame before
    /// m, of the margin, each part of it: the engine's bound, what is not known of the pose, and the way
    /// within one frame.
    double bound{0.0}, pose{0.0}, sampling{0.0};
  };
  std::optional<Decision> decided_by;
  double unseen_share{1.0};              ///< margin::unseenShare of the recordings
  std::vector<double> needed;            ///< m, of each recording in order
  std::optional<margin::GumbelFit> fit;  ///< of `needed`
};

/// m, up to whole millimetres and above `needed`, as a margin has to be.
double roundedUpMargin(double needed);

struct MarginTable {
  std::vector<MarginRow> rows;  ///< part by part, margins rising
  std::vector<ProposedMargin> proposed;
};

/// `margins`: m, rising.
MarginTable marginTable(const std::vector<TunedRecording>& recordings, const std::vector<double>& margins,
                        const TuneOptions& options);

}  // namespace abstand::tune
