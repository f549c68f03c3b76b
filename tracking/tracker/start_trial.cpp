#include "tracking/tracker/start_trial.hpp"

#include <algorithm>

namespace abstand::tracking {
namespace {

constexpr double kLatestPath = 1.0;  // s, of the path's start after the first search
constexpr double kLostCost = 3.0;    // times the usual cost, of an image in which a candidate is lost

}  // namespace

StartTrial::StartTrial(const TrackedPerson::Options& options, std::shared_ptr<const KnownBody> known,
                       double start, double end, double usual_cost)
    : options_{options}, known_{std::move(known)}, lost_cost_{kLostCost * usual_cost} {
  for (std::size_t k = 0; k < kSearches; ++k)
    starts_.push_back({start + kEvery * static_cast<double>(k), false});
  const double on_path = known_->assumed.path.start();
  if (on_path < start + kLatestPath && !known_->facing.lies)
    starts_.push_back({std::max(start, on_path), true});
  for (const Start& one : starts_) counted_from_ = std::max(counted_from_, one.t);
  end_ = std::min(end, counted_from_ + kCounted);
}

bool StartTrial::see(std::size_t number, double t, std::span<const PersonImage> images) {
  while (candidates_.size() < starts_.size() && t >= starts_[candidates_.size()].t) {
    TrackedPerson::Options options = options_;
    options.seed += candidates_.size();
    options.starts_on_path = starts_[candidates_.size()].on_path;
    candidates_.push_back({TrackedPerson(options, known_)});
  }
  for (Candidate& candidate : candidates_) {
    const TrackedBody& body = *candidate.tracker.see(t, images);
    if (body.found || !candidate.seen.empty()) candidate.seen.push_back({number, body});
    if (t >= counted_from_)
      candidate.cost += body.found ? std::min(body.misfit.cost, lost_cost_) : lost_cost_;
  }
  return t >= end_;
}

StartTrial::Candidate& StartTrial::best() {
  auto best = candidates_.begin();
  for (auto it = candidates_.begin(); it != candidates_.end(); ++it)
    if (best->seen.empty() || it->cost < best->cost) best = it;
  return *best;
}

}  // namespace abstand::tracking
