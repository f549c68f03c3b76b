#include "app/tune/margin_table.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tune {
namespace {

constexpr double kMillimetre = 1e-3;

std::vector<std::string> partsOf(const std::vector<TunedRecording>& recordings) {
  std::vector<std::string> parts;
  for (const TunedRecording& r : recordings)
    for (const PartClearance& p : r.pass.parts)
      if (std::find(parts.begin(), parts.end(), p.part) == parts.end()) parts.push_back(p.part);
  return parts;
}

const PartClearance* find(const TunedRecording& recording, const std::string& part) {
  for (const PartClearance& p : recording.pass.parts)
    if (p.part == part) return &p;
  return nullptr;
}

/// Rounded up; a margin has to be above `needed`.
double roundedUp(double needed) {
  return std::isinf(needed) ? needed : (std::floor(needed / kMillimetre) + 1.0) * kMillimetre;
}

ProposedMargin propose(const std::vector<TunedRecording>& recordings, const std::string& part,
                       const margin::MarginOptions& options) {
  ProposedMargin proposed;
  proposed.part = part;
  double most = 0.0;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const PartClearance* clearance = find(recordings[i], part);
    if (!clearance || clearance->track.frames() == 0) continue;
    const margin::SafeMargin safe = margin::smallestSafeMargin(clearance->track, options);
    proposed.needed.push_back(safe.margin);
    if (!safe.decided || (proposed.decided_by && !(safe.margin > most))) continue;
    most = safe.margin;
    const std::size_t before = safe.frame > 0 ? safe.frame - 1 : 0;
    proposed.decided_by = {i,
                           clearance->track.t[safe.frame],
                           recordings[i].pass.links[clearance->link[safe.frame]],
                           clearance->track.clearance[before],
                           clearance->bound[before],
                           clearance->uncertainty[before],
                           safe.sampling};
  }
  proposed.margin = proposed.decided_by ? roundedUp(most) : 0.0;
  proposed.unseen_share = margin::unseenShare(proposed.needed.size());
  proposed.fit = margin::fitGumbel(proposed.needed);
  return proposed;
}

void addRows(const std::string& part, const std::vector<const margin::ClearanceTrack*>& tracks,
             const std::vector<double>& margins, const margin::MarginOptions& options,
             std::vector<MarginRow>& rows) {
  for (const double m : margins) {
    MarginRow row{part, m, {}};
    for (const margin::ClearanceTrack* track : tracks) row.outcome.add(margin::outcome(*track, m, options));
    rows.push_back(std::move(row));
  }
}

/// Frame by frame the nearest of all parts, from where each of them can be judged.
margin::ClearanceTrack wholeBody(const TunedRecording& recording) {
  std::size_t frames = recording.frames;
  for (const PartClearance& p : recording.pass.parts) frames = std::min(frames, p.track.frames());
  std::vector<margin::ClearanceTrack> cut;
  for (const PartClearance& p : recording.pass.parts)
    cut.push_back(margin::from(p.track, p.track.frames() - frames));
  std::vector<const margin::ClearanceTrack*> tracks;
  for (const margin::ClearanceTrack& track : cut) tracks.push_back(&track);
  return margin::leastOf(tracks);
}

}  // namespace

MarginTable marginTable(const std::vector<TunedRecording>& recordings, const std::vector<double>& margins,
                        const TuneOptions& options) {
  MarginTable table;
  const margin::MarginOptions judged = options.margins();
  for (const std::string& part : partsOf(recordings)) {
    std::vector<const margin::ClearanceTrack*> tracks;
    for (const TunedRecording& r : recordings)
      if (const PartClearance* p = find(r, part); p && p->track.frames() > 0) tracks.push_back(&p->track);
    addRows(part, tracks, margins, judged, table.rows);
    table.proposed.push_back(propose(recordings, part, judged));
  }
  std::vector<margin::ClearanceTrack> bodies;
  for (const TunedRecording& r : recordings) bodies.push_back(wholeBody(r));
  std::vector<const margin::ClearanceTrack*> tracks;
  for (const margin::ClearanceTrack& body : bodies)
    if (body.frames() > 0) tracks.push_back(&body);
  addRows(kWholeBody, tracks, margins, judged, table.rows);
  return table;
}

}  // namespace abstand::tune
