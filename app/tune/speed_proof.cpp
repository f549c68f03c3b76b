#include "app/tune/speed_proof.hpp"

#include <algorithm>
#include <cmath>

#include "app/tune/margin_table.hpp"
#include "app/tune/part_frames.hpp"

namespace abstand::tune {
namespace {

// Additional reduction of a speed that would just have been permitted, so that the next replay keeps it.
constexpr double kFurtherSlower = 0.98;
constexpr double kSameMoment = 1e-9;  // s of the program: tolerance of rounded times of frames and segments

/// Segments of the table inside the program; full speed for the rest.
std::vector<PermittedPace> pacesOf(const std::vector<SpeedSegment>& table,
                                   const std::vector<ProgramMotion>& motions) {
  std::vector<PermittedPace> paces;
  for (const SpeedSegment& s : table) paces.push_back({s.t0, s.t1, s.speed_scale});
  const double length = table.empty() ? kInfinity : table.front().t1 - table.front().t0;
  const double end = programEnd(motions);
  double from = table.empty() ? programBegin(motions) : table.back().t1;
  if (!table.empty() && programBegin(motions) < table.front().t0)
    paces.insert(paces.begin(), {programBegin(motions), table.front().t0, 1.0});
  for (; from < end; from += length) paces.push_back({from, std::min(end, from + length), 1.0});
  return paces;
}

/// Collects violations of a replay, and slows down the affected segments.
class ReplayJudge {
 public:
  ReplayJudge(SpeedRule rule, const ProgramPace& pace, std::vector<PermittedPace> scales, SpeedProof& proof)
      : rule_(rule), pace_(pace), lowered_(std::move(scales)), proof_(proof) {}

  void take(const ReplayedRecording& replay) {
    const PartFrames frames(replay.tuned);
    const std::vector<double>& t = frames.times();
    for (std::size_t i = 0; i < t.size(); ++i) {
      bool separation_broken = false;
      for (const PartClearance& part : frames.parts()) {
        separation_broken = separation_broken || part.separation.missing[i] > 0.0;
        const bool contact = part.contact_scale[i] < 1.0;
        proof_.broken_contacts += contact && (i == 0 || !(part.contact_scale[i - 1] < 1.0));
        const double scale = permittedScale(rule_, part.separation.speed_scale[i], part.contact_scale[i]);
        if (scale < 1.0) slowDown(replay, i, part, scale);
      }
      if (separation_broken && i + 1 < t.size()) proof_.broken_time_separation += t[i + 1] - t[i];
    }
  }
  bool broken() const { return broken_; }
  const std::vector<PermittedPace>& lowered() const { return lowered_; }

 private:
  /// Slows down the segments that the robot is in from frame `i` to the next one.
  void slowDown(const ReplayedRecording& replay, std::size_t i, const PartClearance& part, double scale) {
    broken_ = true;
    const std::vector<double>& t = part.track.t;
    const std::size_t next = std::min(i + 1, t.size() - 1);
    const double p0 = pace_.programAt(t[i] + replay.offset), p1 = pace_.programAt(t[next] + replay.offset);
    const double here = p1 > p0 ? (p1 - p0) / (t[next] - t[i]) : 1.0;
    for (PermittedPace& stretch : lowered_) {
      if (stretch.t1 <= p0 + kSameMoment || stretch.t0 >= p1 - kSameMoment) continue;
      stretch.scale = std::min(stretch.scale, here * scale * kFurtherSlower);
      if (stretch.scale >= kSlowestScale || proof_.stands) continue;
      const double contact = part.contact_scale[i], separation = part.separation.speed_scale[i];
      const bool by_contact = !part.contact_excluded && rule_ != SpeedRule::kSeparation &&
                              (rule_ == SpeedRule::kContact || contact < separation);
      proof_.stands = {stretch.t0, stretch.t1, replay.tuned.recording,
                       part.part,  t[i],       by_contact ? SpeedLimit::kContact : SpeedLimit::kSeparation};
    }
  }

  SpeedRule rule_;
  const ProgramPace& pace_;
  std::vector<PermittedPace> lowered_;
  SpeedProof& proof_;
  bool broken_{false};
};

}  // namespace

SpeedProof proveSpeeds(const std::vector<SpeedSegment>& table, const std::vector<TunedRecording>& recorded,
                       ProgramReplay& replay, const ProofOptions& options) {
  SpeedProof proof;
  std::vector<PermittedPace> scales = pacesOf(table, replay.motions());
  proof.scales = scales;
  for (const SpeedSegment& s : table) {
    const auto& limit = s.limited_by;
    if (s.speed_scale >= kSlowestScale || !limit) continue;
    proof.stands = {s.t0, s.t1, recorded[limit->recording].recording, limit->part, limit->t, limit->kind};
    return proof;
  }
  while (proof.iterations < options.max_iterations) {
    ++proof.iterations;
    proof.scales = scales;
    proof.broken_time_separation = 0.0;
    proof.broken_contacts = 0;
    proof.pace = permittedProgram(scales, replay.motions(), options.deceleration);
    const ProgramReplay::Answer runs = replay.run(*proof.pace);
    ReplayJudge judge(options.rule, *proof.pace, scales, proof);
    for (const ReplayedRecording& r : runs.recordings) judge.take(r);
    proof.failed = runs.failed;
    proof.interrupted = runs.interrupted;
    if (runs.interrupted || !runs.failed.empty() || runs.recordings.empty()) return proof;
    proof.proven = !judge.broken();
    if (proof.proven || proof.stands) return proof;
    scales = judge.lowered();
  }
  return proof;
}

std::vector<TradePoint> tradeCurve(const std::vector<double>& scales, ProgramReplay& replay,
                                   const TuneOptions& options) {
  std::vector<TradePoint> curve;
  for (const double scale : scales) {
    const ProgramPace pace =
        ProgramPace::uniform(programBegin(replay.motions()), programEnd(replay.motions()), scale);
    ProgramReplay::Answer runs = replay.run(pace);
    TradePoint point;
    point.speed_scale = scale;
    point.cycle_time = pace.cycleTime();
    point.failed = runs.failed.size();
    point.interrupted = runs.interrupted;
    std::vector<TunedRecording> recordings;
    for (ReplayedRecording& r : runs.recordings) recordings.push_back(std::move(r.tuned));
    for (const TunedRecording& r : recordings) point.unjudged += r.unjudged;
    point.margin = recordings.empty() ? kInfinity : 0.0;
    for (const ProposedMargin& p : marginTable(recordings, {}, options).proposed)
      point.margin = std::max(point.margin, p.margin);
    point.stopped_share = kNaN;
    if (std::isfinite(point.margin))
      for (const MarginRow& row : marginTable(recordings, {point.margin}, options).rows)
        if (row.part == kWholeBody) point.stopped_share = row.outcome.stoppedShare();
    curve.push_back(point);
    if (point.interrupted) break;
  }
  return curve;
}

}  // namespace abstand::tune
