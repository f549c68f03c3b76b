#include "app/tune/margin_table.hpp"

#include <algorithm>

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

/// A part from the first frame from which a margin can be judged.
struct JudgedPart {
  const TunedRecording* recording;
  std::size_t index;  ///< of the recording
  const PartClearance* part;
  std::size_t first;
  margin::ClearanceTrack track;
};

std::vector<JudgedPart> judgedParts(const std::vector<TunedRecording>& recordings, const std::string& name,
                                    const margin::MarginOptions& options) {
  std::vector<JudgedPart> judged;
  for (std::size_t i = 0; i < recordings.size(); ++i)
    for (const PartClearance& p : recordings[i].pass.parts) {
      if (p.part != name) continue;
      const std::size_t first = margin::firstJudgedFrame(p.track, options);
      if (first < p.track.frames())
        judged.push_back({&recordings[i], i, &p, first, margin::from(p.track, first)});
    }
  return judged;
}

ProposedMargin propose(const std::vector<JudgedPart>& judged, const std::string& part,
                       const margin::MarginOptions& options) {
  ProposedMargin proposed;
  proposed.part = part;
  double most = 0.0;
  for (const JudgedPart& j : judged) {
    const margin::SafeMargin safe = margin::smallestSafeMargin(j.track, options);
    proposed.needed.push_back(safe.margin);
    if (!safe.decided || (proposed.decided_by && !(safe.margin > most))) continue;
    most = safe.margin;
    const std::size_t told = j.first + safe.frame, before = told > j.first ? told - 1 : told;
    proposed.decided_by = {j.index,
                           j.part->track.t[told],
                           j.recording->pass.links[j.part->link[told]],
                           j.recording->pass.toolName(j.part->tool[told]),
                           j.part->track.clearance[before],
                           j.part->bound[before],
                           j.part->uncertainty[before],
                           safe.sampling};
  }
  proposed.margin = proposed.decided_by ? roundedUpMargin(most) : 0.0;
  proposed.unseen_share = margin::unseenShare(proposed.needed.size());
  proposed.fit = margin::fitGumbel(proposed.needed);
  return proposed;
}

void addRows(const std::string& part, const std::vector<const margin::ClearanceTrack*>& tracks,
             const std::vector<double>& margins, const margin::MarginOptions& options,
             std::vector<MarginRow>& rows) {
  const std::size_t first = rows.size();
  for (const double m : margins) rows.push_back({part, m, {}});
  for (const margin::ClearanceTrack* track : tracks) {
    const std::vector<margin::MarginOutcome> outcomes = margin::outcomes(*track, margins, options);
    for (std::size_t k = 0; k < outcomes.size(); ++k) rows[first + k].outcome.add(outcomes[k]);
  }
}

/// Frame-wise minimum over all parts, from the frame on from which each can be judged.
margin::ClearanceTrack wholeBody(const TunedRecording& recording, const margin::MarginOptions& options) {
  std::vector<const margin::ClearanceTrack*> tracks;
  for (const PartClearance& p : recording.pass.parts) tracks.push_back(&p.track);
  return margin::from(margin::leastOf(tracks), firstJudgedFrame(recording, options));
}

}  // namespace

MarginTable marginTable(const std::vector<TunedRecording>& recordings, const std::vector<double>& margins,
                        const TuneOptions& options) {
  MarginTable table;
  const margin::MarginOptions judged = options.margins();
  for (const std::string& part : partsOf(recordings)) {
    const std::vector<JudgedPart> parts = judgedParts(recordings, part, judged);
    std::vector<const margin::ClearanceTrack*> tracks;
    for (const JudgedPart& p : parts) tracks.push_back(&p.track);
    addRows(part, tracks, margins, judged, table.rows);
    table.proposed.push_back(propose(parts, part, judged));
  }
  std::vector<margin::ClearanceTrack> bodies;
  for (const TunedRecording& r : recordings) bodies.push_back(wholeBody(r, judged));
  std::vector<const margin::ClearanceTrack*> tracks;
  for (const margin::ClearanceTrack& body : bodies)
    if (body.frames() > 0) tracks.push_back(&body);
  addRows(kWholeBody, tracks, margins, judged, table.rows);
  return table;
}

}  // namespace abstand::tune
