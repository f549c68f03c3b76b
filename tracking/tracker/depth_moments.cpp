#include "tracking/tracker/depth_moments.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quantile.hpp"

namespace abstand::tracking {
namespace {

constexpr double kOfStep = 0.6;  // share of a camera's step within which an image belongs to a moment

double usualStep(const std::vector<double>& t) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
  return steps.empty() ? kInfinity : nearestQuantile(steps, 0.5);
}

/// Index of the time nearest to `t`; `times` increases and is not empty.
std::size_t nearestIn(const std::vector<double>& times, double t) {
  const auto after = std::lower_bound(times.begin(), times.end(), t);
  const auto i = static_cast<std::size_t>(after - times.begin());
  if (i == times.size()) return i - 1;
  return i > 0 && t - times[i - 1] <= times[i] - t ? i - 1 : i;
}

}  // namespace

DepthMoments::DepthMoments(std::span<const ClipCamera> cameras) {
  for (const ClipCamera& camera : cameras) {
    Reader& reader = readers_.emplace_back();
    reader.camera = camera;
    for (const double t : camera.stream->times()) reader.t.push_back(t + camera.offset);
    reader.farthest = std::min(kFarthest, kOfStep * usualStep(reader.t));
    std::vector<double> more;
    for (const double t : reader.t)
      if (times_.empty() || std::abs(times_[nearestIn(times_, t)] - t) > kGap) more.push_back(t);
    const auto middle = static_cast<std::ptrdiff_t>(times_.size());
    times_.insert(times_.end(), more.begin(), more.end());
    std::inplace_merge(times_.begin(), times_.begin() + middle, times_.end());
  }
  rewind();
}

void DepthMoments::rewind() {
  next_ = 0;
  for (Reader& reader : readers_) {
    reader.at = kNone;
    reader.camera.stream->seek(0);
  }
}

bool DepthMoments::next(DepthMoment& moment) {
  if (next_ == times_.size()) return false;
  moment.t = times_[next_++];
  moment.frames.assign(readers_.size(), nullptr);
  moment.is_new.assign(readers_.size(), false);
  moment.lag = 0.0;
  for (std::size_t c = 0; c < readers_.size(); ++c) {
    Reader& reader = readers_[c];
    if (reader.t.empty()) continue;
    const std::size_t i = nearestIn(reader.t, moment.t);
    const double off = std::abs(reader.t[i] - moment.t);
    if (off > reader.farthest) continue;
    if (reader.at != i) {
      reader.camera.stream->seek(i);
      if (!reader.camera.stream->next(reader.frame)) continue;
      reader.at = i;
      moment.is_new[c] = true;
    }
    moment.frames[c] = &reader.frame;
    moment.lag = std::max(moment.lag, off);
  }
  return true;
}

}  // namespace abstand::tracking
