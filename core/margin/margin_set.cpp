#include "core/margin/margin_set.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::margin {

MarginSets::MarginSets(std::vector<const ClearanceTrack*> tracks) : tracks_(std::move(tracks)) {
  if (tracks_.empty()) throw UsageError("found no clearance track, expected one or more");
  frames_ = tracks_.front()->frames();
  block_count_ = (frames_ + kBlock - 1) / kBlock;
  of_all_.assign(block_count_, {kInfinity, -kInfinity, kInfinity});
  for (const ClearanceTrack* track : tracks_) {
    if (track->t != tracks_.front()->t)
      throw UsageError("found clearance tracks with different times, expected the same");
    for (std::size_t b = 0; b < block_count_; ++b) {
      Block block{kInfinity, -kInfinity, kInfinity};
      for (std::size_t i = b * kBlock; i < std::min(frames_, (b + 1) * kBlock); ++i) {
        block.least = std::min(block.least, track->clearance[i]);
        block.largest = std::max(block.largest, track->clearance[i]);
        block.between = std::min(block.between, track->between[i]);
      }
      blocks_.push_back(block);
      of_all_[b].least = std::min(of_all_[b].least, block.least);
      of_all_[b].between = std::min(of_all_[b].between, block.between);
    }
  }
}

bool MarginSets::inside(std::size_t frame, std::span<const double> margins) const {
  for (std::size_t k = 0; k < tracks_.size(); ++k)
    if (tracks_[k]->clearance[frame] < margins[k]) return true;
  return false;
}

bool MarginSets::allOutside(std::size_t b, std::span<const double> margins) const {
  for (std::size_t k = 0; k < tracks_.size(); ++k)
    if (block(k, b).least < margins[k]) return false;
  return true;
}

bool MarginSets::allInside(std::size_t b, std::span<const double> margins) const {
  for (std::size_t k = 0; k < tracks_.size(); ++k)
    if (block(k, b).largest < margins[k]) return true;
  return false;
}

double MarginSets::leastAt(std::size_t frame) const {
  double least = kInfinity;
  for (const ClearanceTrack* track : tracks_) least = std::min(least, track->clearance[frame]);
  return least;
}

double MarginSets::betweenAt(std::size_t frame) const {
  double least = kInfinity;
  for (const ClearanceTrack* track : tracks_) least = std::min(least, track->between[frame]);
  return least;
}

MarginSets::Run MarginSets::runFrom(std::size_t begin, std::span<const double> margins,
                                    const MarginOptions& options) const {
  Run run;
  std::size_t i = begin;
  while (i < frames_) {
    const std::size_t b = i / kBlock;
    // A block that reaches the limit is scanned frame by frame, for the lead time.
    const bool near = std::min(of_all_[b].least, of_all_[b].between) <= options.limit && !run.lead_time;
    if (i % kBlock == 0 && !near && allInside(b, margins)) {
      run.least = std::min({run.least, of_all_[b].least, of_all_[b].between});
      i = std::min(frames_, i + kBlock);
      continue;
    }
    if (!inside(i, margins)) break;
    const double least = std::min(leastAt(i), betweenAt(i));
    if (least <= options.limit && !run.lead_time)
      run.lead_time = tracks_.front()->t[i] - tracks_.front()->t[begin];
    run.least = std::min(run.least, least);
    ++i;
  }
  run.end = i;
  return run;
}

MarginOutcome MarginSets::outcome(std::span<const double> margins, const MarginOptions& options) const {
  MarginOutcome out;
  const std::vector<double>& t = tracks_.front()->t;
  out.time = tracks_.front()->duration();
  double stopped_until = -kInfinity;  // s
  for (std::size_t i = 0; i < frames_;) {
    const std::size_t b = i / kBlock;
    if (i % kBlock == 0 && of_all_[b].between > options.limit && allOutside(b, margins)) {
      out.min_clearance = std::min({out.min_clearance, of_all_[b].least, of_all_[b].between});
      i += kBlock;
      continue;
    }
    if (!inside(i, margins)) {
      const double between = betweenAt(i);
      out.min_clearance = std::min({out.min_clearance, leastAt(i), between});
      if (between <= options.limit) ++out.unseen;
      ++i;
      continue;
    }
    const Run run = runFrom(i, margins, options);
    double braking = kInfinity;
    for (const ClearanceTrack* track : tracks_) braking = std::min(braking, track->braking[i]);
    const double until =
        std::min(t.back(), (run.end < frames_ ? t[run.end] : t.back()) + options.restart_time);
    out.stopped_time += std::max(0.0, until - std::max(t[i], stopped_until));
    stopped_until = std::max(stopped_until, until);
    ++out.stops;
    out.false_stops += run.least > options.limit;
    out.missed_stops += braking <= options.limit;
    out.min_clearance = std::min(out.min_clearance, braking);
    if (run.lead_time && (!out.lead_time || *run.lead_time < *out.lead_time)) out.lead_time = run.lead_time;
    i = run.end;
  }
  out.missed_stops += out.unseen;
  return out;
}

}  // namespace abstand::margin
