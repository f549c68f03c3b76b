// What `tune` and `merge` answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/tune/speed_table.hpp"
#include "app/tune/study.hpp"
#include "app/tune/worst_phase.hpp"

namespace abstand::tune {

struct TuneAnswer {
  TuneOptions options;
  std::vector<TunedRecording> recordings;
  std::vector<FailedRun> failed;
  std::optional<std::size_t> made, kept;  ///< result files, where there are any
  MarginTable table;
  std::vector<SpeedSegment> speeds;
  /// Where it was asked for: of each recording.
  struct RecordingPhases {
    std::string recording;
    std::vector<WorstPhase> parts;
  };
  std::vector<RecordingPhases> worst_phases;
  bool interrupted{false};
};

/// What mergeResults() finds, with the options of the results; tables are still to be made. Throws likewise.
TuneAnswer mergedAnswer(const std::vector<std::filesystem::path>& folders);

/// The approaches of all recordings, nearest first.
struct RankedApproach {
  const TunedRecording* recording;
  const Approach* approach;
};
std::vector<RankedApproach> rankedApproaches(const TuneAnswer& answer);

}  // namespace abstand::tune
