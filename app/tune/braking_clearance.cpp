#include "app/tune/braking_clearance.hpp"

#include <algorithm>

namespace abstand::tune {
namespace {

constexpr double kTolerance = 1e-4;  // m, as for the check between frames
constexpr int kMaxSamples = 128;

}  // namespace

BrakingClearance::BrakingClearance(const session::Session& session, const MotionWindow& window, double limit)
    : session_(session),
      window_(window),
      limit_(limit),
      halts_(session.mechanisms().size()),
      pairs_of_(halts_.size()),
      links_of_(halts_.size()),
      in_step_(window.pairs().size()),
      uncertainty_(window.pairs().size()),
      fastest_(session.scene().objects().size()),
      braking_(fastest_.size()),
      memories_(window.pairs().size()) {
  for (std::size_t p = 0; p < window.pairs().size(); ++p) {
    const WatchedPair& pair = window.pairs()[p];
    std::vector<PairRange>& ranges = pairs_of_[pair.robot];
    if (!ranges.empty() && ranges.back().end == p)
      ++ranges.back().end;
    else
      ranges.push_back({p, p + 1});
    std::vector<std::size_t>& links = links_of_[pair.robot];
    if (std::find(links.begin(), links.end(), pair.link) == links.end()) links.push_back(pair.link);
  }
}

bool BrakingClearance::ofFirst(std::vector<double>& out) {
  for (std::size_t r = 0; r < halts_.size(); ++r) {
    const auto halt = window_.haltOfFirst(r);
    if (!halt) return false;
    halts_[r] = *halt;
  }
  for (std::size_t r = 0; r < halts_.size(); ++r) gather(r);
  out.resize(window_.pairs().size());
  for (std::size_t p = 0; p < out.size(); ++p) out[p] = ofPair(p, halts_[window_.pairs()[p].robot]);
  return true;
}

Eigen::Map<Eigen::ArrayXd> BrakingClearance::values(std::vector<double>& of_pairs, const PairRange& range) {
  return {of_pairs.data() + range.begin, static_cast<Eigen::Index>(range.end - range.begin)};
}

Eigen::Map<const Eigen::ArrayXd> BrakingClearance::values(const std::vector<double>& of_pairs,
                                                          const PairRange& range) {
  return {of_pairs.data() + range.begin, static_cast<Eigen::Index>(range.end - range.begin)};
}

/// Frame by frame instead of pair by pair, as the values of a frame lie side by side in memory.
void BrakingClearance::gather(std::size_t robot) {
  const Halt& halt = halts_[robot];
  const auto& frames = window_.frames();
  const WindowFrame& first = frames.front();
  const double end = std::min(first.t + halt.duration(), frames.back().t);
  const double path_end = first.t + halt.programTime(halt.duration());
  const std::vector<PairRange>& pairs = pairs_of_[robot];
  for (const PairRange& range : pairs)
    for (std::size_t p = range.begin; p < range.end; ++p) {
      in_step_[p] = first.clearance[p] + first.uncertainty[p];
      uncertainty_[p] = std::max(0.0, first.uncertainty[p]);
    }
  for (const std::size_t link : links_of_[robot]) fastest_[link] = braking_[link] = 0.0;
  for (std::size_t k = 0; k + 1 < frames.size() && frames[k].t < end; ++k) {
    const WindowFrame &now = frames[k], &next = frames[k + 1];
    for (const PairRange& range : pairs) {
      values(in_step_, range) = values(in_step_, range).min(values(now.between, range));
      values(uncertainty_, range) = values(uncertainty_, range).max(values(next.uncertainty, range));
    }
    for (const std::size_t link : links_of_[robot]) {
      fastest_[link] = std::max(fastest_[link], now.speed[link]);
      if (now.t <= path_end) braking_[link] = std::max(braking_[link], now.speed[link]);
    }
  }
}

double BrakingClearance::ofPair(std::size_t p, const Halt& halt) {
  const std::size_t link = window_.pairs()[p].link;
  const auto& frames = window_.frames();
  const double begin = frames.front().t, end = std::min(begin + halt.duration(), frames.back().t);
  const double uncertainty = uncertainty_[p];
  if (braking_[link] == 0.0) return kInfinity;
  // The link lags behind its recorded position by at most half the braking time, so its distance from there
  // is at most its fastest motion in that time.
  const double lagging = in_step_[p] - uncertainty - fastest_[link] * 0.5 * halt.braking;
  if (lagging > limit_ + kExact) return lagging;
  if (uncertainty == kInfinity) return -kInfinity;
  return std::max(lagging, exact(p, halt, end - begin, uncertainty) - uncertainty);
}

double BrakingClearance::exact(std::size_t p, const Halt& halt, double duration, double uncertainty) {
  const WatchedPair& pair = window_.pairs()[p];
  const auto& frames = window_.frames();
  const double begin = frames.front().t;
  const scene::Scene& scene = session_.scene();
  const structure::HapticStructure &part = *scene.objects()[pair.part].spec.structure,
                                   &link = *scene.objects()[pair.link].spec.structure;
  const auto poseAt = [&](std::size_t object, double t) {
    const std::size_t k = std::min(window_.indexAt(t), frames.size() - 1);
    if (k + 1 >= frames.size()) return frames[k].X_WB[object];
    safety::PoseSegment motion = frames[k].motion[object];
    return motion.pose(t - frames[k].t);
  };
  const auto fastest = [&](std::size_t object, double t0, double t1) {
    double speed = 0.0;
    for (std::size_t k = window_.indexAt(t0); k + 1 < frames.size() && frames[k].t <= t1; ++k)
      speed = std::max(speed, frames[k].speed[object]);
    return speed;
  };
  const auto sample = [&](double t) {
    const Transform X_part = poseAt(pair.part, begin + t),
                    X_link = poseAt(pair.link, begin + halt.programTime(t));
    query::PairOptions options = scene.pairs()[pair.id.index()].options;
    options.margin = 0.0;
    query::queryPair({part, X_part}, {link, X_link}, options, {memories_[p], scratch_}, result_);
    return safety::DistanceSample{result_.distance - result_.bound, result_.distance};
  };
  const auto rate = [&](double t0, double t1) {
    return fastest(pair.part, begin + t0, begin + t1) +
           halt.pace(t0) * fastest(pair.link, begin + halt.programTime(t0), begin + halt.programTime(t1));
  };
  safety::SweptOptions options;
  options.tolerance = kTolerance;
  options.enough = limit_ + kExact + uncertainty;
  options.max_samples = kMaxSamples;
  const safety::SweptResult swept = safety::sweptDistance(duration, sample, rate, options);
  queries_ += swept.samples;
  return swept.lower;
}

}  // namespace abstand::tune
