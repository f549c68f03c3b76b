#include "app/tune/tune_answer.hpp"

#include <algorithm>

namespace abstand::tune {

TuneAnswer mergedAnswer(const std::vector<std::filesystem::path>& folders) {
  MergedResults merged = mergeResults(folders);
  TuneAnswer answer;
  answer.options = merged.options;
  answer.recordings = std::move(merged.recordings);
  answer.kept = answer.recordings.size();
  return answer;
}

std::vector<RankedApproach> rankedApproaches(const TuneAnswer& answer) {
  std::vector<RankedApproach> ranked;
  for (const TunedRecording& r : answer.recordings)
    for (const Approach& a : r.pass.approaches) ranked.push_back({&r, &a});
  std::stable_sort(ranked.begin(), ranked.end(), [](const RankedApproach& a, const RankedApproach& b) {
    return a.approach->clearance < b.approach->clearance;
  });
  return ranked;
}

}  // namespace abstand::tune
