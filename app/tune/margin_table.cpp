#include "app/tune/margin_table.hpp"

#include <algorithm>
#include <map>

#include "app/tune/part_frames.hpp"
#include "core/margin/margin_outcome.hpp"

namespace abstand::tune {
namespace {

std::vector<std::string> partsOf(const std::vector<TunedRecording>& recordings) {
  std::vector<std::string> parts;
  for (const TunedRecording& r : recordings)
    for (const PartClearance& p : r.pass.parts)
      if (std::find(parts.begin(), parts.end(), p.part) == parts.end()) parts.push_back(p.part);
  return parts;
}

/// Rows of one part, and the proposed margin, recording by recording.
class PartRows {
 public:
  PartRows(const std::string& part, const std::vector<double>& margins, const margin::MarginOptions& options)
      : margins_(margins), options_(options) {
    proposed_.part = part;
    for (const double m : margins) rows_.push_back({part, m, {}});
  }

  /// `track`: from the frame on from which a margin can be judged.
  void add(const margin::ClearanceTrack& track) {
    const std::vector<margin::MarginOutcome> outcomes = margin::outcomes(track, margins_, options_);
    for (std::size_t k = 0; k < outcomes.size(); ++k) rows_[k].outcome.add(outcomes[k]);
  }
  void propose(const TunedRecording& recording, std::size_t index, const PartClearance& part) {
    const std::size_t first = margin::firstJudgedFrame(part.track, options_);
    if (first >= part.track.frames()) return;
    const margin::ClearanceTrack track = margin::from(part.track, first);
    add(track);
    double& longest = judged_[recording.content];
    longest = std::max(longest, track.duration());
    const margin::SafeMargin safe = margin::smallestSafeMargin(track, options_);
    proposed_.needed.push_back(safe.margin);
    if (!safe.decided || (proposed_.decided_by && !(safe.margin > largest_))) return;
    largest_ = safe.margin;
    const std::size_t told = first + safe.frame, before = told > first ? told - 1 : told;
    proposed_.decided_by = {index,
                            part.track.t[told],
                            recording.pass.links[part.link[told]],
                            recording.pass.toolName(part.tool[told]),
                            part.track.clearance[before],
                            part.bound[before],
                            part.uncertainty[before],
                            safe.sampling};
  }

  const std::vector<MarginRow>& rows() const { return rows_; }
  ProposedMargin proposed() {
    proposed_.margin = proposed_.decided_by ? roundedUpMargin(largest_) : 0.0;
    for (const auto& [content, time] : judged_) proposed_.judged_time += time;
    proposed_.unseen_share = margin::unseenShare(proposed_.needed.size());
    proposed_.fit = margin::fitGumbel(proposed_.needed);
    return std::move(proposed_);
  }

 private:
  const std::vector<double>& margins_;
  margin::MarginOptions options_;
  std::vector<MarginRow> rows_;
  ProposedMargin proposed_;
  double largest_{0.0};  ///< m
  /// s, by content: variants of one recording add no time, because they show the same work again.
  std::map<std::string, double> judged_;
};

}  // namespace

double shortestJudgedTime(const MarginTable& table) {
  double shortest = kInfinity;
  for (const ProposedMargin& p : table.proposed) shortest = std::min(shortest, p.judged_time);
  return table.proposed.empty() ? 0.0 : shortest;
}

MarginTable marginTable(const std::vector<TunedRecording>& recordings, const std::vector<double>& margins,
                        const TuneOptions& options) {
  const margin::MarginOptions judged = options.margins();
  std::vector<PartRows> parts;
  const std::vector<std::string> names = partsOf(recordings);
  for (const std::string& part : names) parts.emplace_back(part, margins, judged);
  PartRows body(kWholeBody, margins, judged);
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    PartByPart of_recording(recordings[i]);
    WholeBody whole;
    for (std::size_t p = 0; p < of_recording.size(); ++p) {
      const PartClearance& part = of_recording.part(p);
      const auto index = std::distance(names.begin(), std::find(names.begin(), names.end(), part.part));
      parts[static_cast<std::size_t>(index)].propose(recordings[i], i, part);
      whole.take(part.track, judged);
    }
    if (whole.first < whole.track.frames()) body.add(margin::from(whole.track, whole.first));
  }
  MarginTable table;
  for (PartRows& part : parts) {
    table.rows.insert(table.rows.end(), part.rows().begin(), part.rows().end());
    table.proposed.push_back(part.proposed());
  }
  table.rows.insert(table.rows.end(), body.rows().begin(), body.rows().end());
  return table;
}

}  // namespace abstand::tune
