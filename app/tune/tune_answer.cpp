#include "app/tune/tune_answer.hpp"

#include <algorithm>
#include <set>

namespace abstand::tune {

void answerQuestions(const TuneQuestions& questions, TuneAnswer& answer) {
  answer.table = marginTable(answer.recordings, questions.margins, answer.options);
  answer.speeds = speedTable(answer.recordings, questions.segment, questions.speed_rule);
  answer.speed_rule = questions.speed_rule;
  answer.exposure = exposureTable(answer.recordings, questions.segment, answer.options.pass.near);
  answer.links = linkNeeds(answer.recordings);
  answer.pairs = pairNeeds(answer.recordings);
  answer.closest = closestApproaches(answer.recordings, answer.options.pass.calibration_error);
  answer.bands = variantBands(answer.recordings, answer.options.margins());
  std::vector<MarginRules> sets = proposedRules(answer.recordings, answer.table);
  sets.insert(sets.end(), questions.margin_sets.begin(), questions.margin_sets.end());
  answer.strategies = strategyOutcomes(answer.recordings, sets, answer.options.margins());
}

TuneAnswer mergedAnswer(const std::vector<std::filesystem::path>& folders) {
  MergedResults merged = mergeResults(folders);
  TuneAnswer answer;
  answer.options = merged.options;
  answer.recordings = std::move(merged.recordings);
  answer.kept = answer.recordings.size();
  return answer;
}

std::vector<std::string> clampedParts(const std::vector<TunedRecording>& recordings) {
  std::set<std::string> parts;
  for (const TunedRecording& r : recordings) parts.insert(r.clamped.begin(), r.clamped.end());
  return {parts.begin(), parts.end()};
}

std::optional<run::RunSummary::WarmStart> warmStartOf(const std::vector<TunedRecording>& recordings) {
  std::optional<run::RunSummary::WarmStart> largest;
  for (const TunedRecording& r : recordings)
    if (r.warm_start && !(largest && largest->far_tolerance >= r.warm_start->far_tolerance))
      largest = r.warm_start;
  return largest;
}

std::vector<InputFile> inputFiles(const std::vector<TunedRecording>& recordings) {
  std::vector<InputFile> files;
  std::set<std::pair<std::string, std::string>> known;
  for (const TunedRecording& r : recordings)
    for (const InputFile& file : r.files)
      if (known.emplace(file.name, file.content).second) files.push_back(file);
  return files;
}

std::optional<EnclosedRange> enclosedRange(const std::vector<TunedRecording>& recordings,
                                           const std::string& part) {
  std::optional<EnclosedRange> range;
  for (const TunedRecording& r : recordings)
    for (std::size_t p = 0; p < std::min(r.enclosed.size(), r.pass.parts.size()); ++p) {
      if (r.pass.parts[p].part != part) continue;
      const humanmodel::EnclosedShare& here = r.enclosed[p];
      if (!range) range = EnclosedRange{here, here};
      range->min = {std::min(range->min.at_stature, here.at_stature),
                    std::min(range->min.all_statures, here.all_statures)};
      range->max = {std::max(range->max.at_stature, here.at_stature),
                    std::max(range->max.all_statures, here.all_statures)};
    }
  return range;
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
