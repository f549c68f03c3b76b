// Outcomes of sets of margins over recordings, all parts and links together.
#pragma once

#include "app/tune/margin_rules.hpp"
#include "app/tune/margin_table.hpp"

namespace abstand::tune {

struct StrategyOutcome {
  MarginRules rules;
  margin::MarginOutcome outcome;
};

/// The margin of each pair of the recording, in its order. Throws UsageError for a pair without one.
std::vector<margin::PairMargin> marginsOf(const TunedRecording& recording, const MarginRules& rules);

/// Throws UsageError for a rule that names a part or a link of no recording: it is a slip of the pen, and the
/// pair that was meant has another margin.
void checkNames(const std::vector<TunedRecording>& recordings, const MarginRules& rules);

/// Judges every set over every recording, whose result files are read (TunedRecording::file). Recordings
/// count from the first frame on from which every part can be judged. Throws UsageError for a rule that names
/// a part or a link of no recording, and for a pair without a margin; ParseError for a damaged file.
std::vector<StrategyOutcome> strategyOutcomes(const std::vector<TunedRecording>& recordings,
                                              const std::vector<MarginRules>& sets,
                                              const margin::MarginOptions& options);

/// Smallest safe margins as sets: "uniform" (the largest one for all), "per_part", "per_link" and "per_pair".
/// Rounded up to whole millimetres. Sets without a sufficient margin are omitted.
std::vector<MarginRules> proposedRules(const std::vector<TunedRecording>& recordings,
                                       const MarginTable& table);

/// Smallest safe margin of a link or a pair over all recordings.
struct GroupNeed {
  std::string part, link;                ///< part: empty for a link
  double margin{0.0};                    ///< m, rounded up to whole millimetres; infinite if none suffices
  std::optional<std::size_t> recording;  ///< index of the decisive one; nullopt: no stop was ever needed
  MarginNeed need;                       ///< of that recording
};
std::vector<GroupNeed> linkNeeds(const std::vector<TunedRecording>& recordings);
std::vector<GroupNeed> pairNeeds(const std::vector<TunedRecording>& recordings);

}  // namespace abstand::tune
