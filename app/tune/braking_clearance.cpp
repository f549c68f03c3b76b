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
      memories_(window.pairs().size()) {}

bool BrakingClearance::ofFirst(std::vector<double>& out) {
  for (std::size_t r = 0; r < halts_.size(); ++r) {
    const auto halt = window_.haltOfFirst(r);
    if (!halt) return false;
    halts_[r] = *halt;
  }
  out.resize(window_.pairs().size());
  for (std::size_t p = 0; p < out.size(); ++p) out[p] = ofPair(p, halts_[window_.pairs()[p].robot]);
  return true;
}

double BrakingClearance::ofPair(std::size_t p, const Halt& halt) {
  const WatchedPair& pair = window_.pairs()[p];
  const auto& frames = window_.frames();
  const double begin = frames.front().t, end = std::min(begin + halt.duration(), frames.back().t);
  double fastest = 0.0, braking = 0.0, uncertainty = 0.0;
  double in_step = frames.front().clearance[p] + frames.front().uncertainty[p];
  const double path_end = begin + halt.programTime(halt.duration());
  for (std::size_t k = 0; k < frames.size() && frames[k].t <= end; ++k) {
    uncertainty = std::max(uncertainty, frames[k].uncertainty[p]);
    if (k + 1 == frames.size() || frames[k].t == end) break;
    in_step = std::min(in_step, frames[k].between[p]);
    fastest = std::max(fastest, frames[k].speed[pair.link]);
    if (frames[k].t <= path_end) braking = std::max(braking, frames[k].speed[pair.link]);
    uncertainty = std::max(uncertainty, frames[k + 1].uncertainty[p]);
  }
  if (braking == 0.0) return kInfinity;
  // The link lags behind its recorded position by at most half the braking time, so its distance from there
  // is at most its fastest motion in that time.
  const double lagging = in_step - uncertainty - fastest * 0.5 * halt.braking;
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
