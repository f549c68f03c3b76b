#include "app/tune/motion_window.hpp"

#include <algorithm>
#include <cmath>

#include "core/safety/clearance_verdict.hpp"

namespace abstand::tune {

MotionWindow::MotionWindow(const session::Session& session, std::vector<WatchedPair> pairs,
                           const BrakingOptions& options, ExtraUncertainty extra)
    : session_(session), pairs_(std::move(pairs)), options_(options), extra_(std::move(extra)) {}

double MotionWindow::uncertaintyOf(const WatchedPair& pair) const {
  return session_.scene().pairUncertainty(pair.id) + extra_.calibration_error + latencyOf(pair);
}

WindowFrame MotionWindow::emptyFrame() {
  if (spare_.empty()) return {};
  WindowFrame frame = std::move(spare_.back());
  spare_.pop_back();
  frame.X_WB.clear();
  for (auto* list : {&frame.q, &frame.distance, &frame.bound, &frame.clearance, &frame.uncertainty,
                     &frame.age_uncertainty, &frame.between, &frame.speed, &frame.braking_time})
    list->clear();
  frame.on_part.clear();
  frame.on_link.clear();
  frame.motion.clear();
  return frame;
}

void MotionWindow::add(double t, const std::vector<query::PairResult>& results,
                       std::span<const double> between, std::span<const safety::PoseSegment> motions) {
  const scene::Scene& scene = session_.scene();
  WindowFrame now = emptyFrame();
  now.t = t;
  for (const scene::Object& o : scene.objects()) now.X_WB.push_back(o.X_WB);
  for (const auto& m : session_.mechanisms()) now.q.insert(now.q.end(), m->q().begin(), m->q().end());
  lost_.clear();
  for (const scene::Object& o : scene.objects()) lost_.push_back(scene::isPoseLost(o.pose_state));
  for (auto* list : {&now.distance, &now.bound, &now.clearance, &now.uncertainty, &now.age_uncertainty})
    list->resize(pairs_.size());
  now.on_part.resize(pairs_.size());
  now.on_link.resize(pairs_.size());
  now.lost.resize(pairs_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const WatchedPair& p = pairs_[i];
    const query::PairResult& r = results[p.id.index()];
    const double uncertainty = uncertaintyOf(p);
    now.distance[i] = r.distance;
    now.bound[i] = r.bound;
    now.on_part[i] = p.part_is_a ? r.witness_a : r.witness_b;
    now.on_link[i] = p.part_is_a ? r.witness_b : r.witness_a;
    now.clearance[i] = safety::certifiedClearance({r.distance, r.bound, uncertainty});
    now.uncertainty[i] = uncertainty;
    now.lost[i] = lost_[p.part] || lost_[p.link];
    now.age_uncertainty[i] =
        scene.objects()[p.part].pose_age_uncertainty + scene.objects()[p.link].pose_age_uncertainty;
  }
  if (!frames_.empty()) {
    WindowFrame& last = frames_.back();
    const double duration = t - last.t;
    last.motion.assign(motions.begin(), motions.end());
    for (const safety::PoseSegment& motion : motions) last.speed.push_back(motion.speed(0.0, duration));
    for (const WatchedPair& p : pairs_) last.between.push_back(between[p.id.index()]);
    std::size_t first = 0;
    for (const auto& m : session_.mechanisms()) {
      double longest = 0.0;
      for (std::size_t j = first; j < first + m->q().size(); ++j)
        longest = std::max(longest, std::abs(now.q[j] - last.q[j]) / duration / options_.deceleration);
      first += m->q().size();
      last.braking_time.push_back(longest);
    }
  }
  frames_.push_back(std::move(now));
}

std::size_t MotionWindow::indexAt(double t) const {
  const auto after = std::upper_bound(frames_.begin(), frames_.end(), t,
                                      [](double x, const WindowFrame& f) { return x < f.t; });
  return after == frames_.begin() ? 0 : static_cast<std::size_t>(after - frames_.begin()) - 1;
}

std::optional<Halt> MotionWindow::haltOfFirst(std::size_t robot) const {
  Halt halt{options_.reaction_time, 0.0};
  const double begin = frames_.front().t + halt.reaction;
  // If the path gets faster while the robot brakes, it brakes longer; repeated until nothing faster follows.
  for (;;) {
    const double end = begin + 0.5 * halt.braking;
    // The following frame determines the speed of the path there.
    if (frames_.back().t <= end && !finished_) return std::nullopt;
    double longest = 0.0;
    for (std::size_t k = indexAt(begin); k + 1 < frames_.size() && frames_[k].t <= end; ++k)
      longest = std::max(longest, frames_[k].braking_time[robot]);
    if (longest <= halt.braking) break;
    halt.braking = longest;
  }
  if (frames_.back().t < frames_.front().t + halt.duration() && !finished_) return std::nullopt;
  return halt;
}

}  // namespace abstand::tune
