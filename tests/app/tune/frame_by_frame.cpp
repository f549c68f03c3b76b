#include "tests/app/tune/frame_by_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/query/pair_query.hpp"

namespace abstand::testing {
namespace {

constexpr double kRounding = 1e-9;  // s

}  // namespace

void Sampled::take(const Sampled& other) {
  measured = std::min(measured, other.measured);
  certain = std::min(certain, other.certain);
}

FrameByFrame::FrameByFrame(session::Session& session, const Options& options, const run::RunOptions& run)
    : session_(session), options_(options), pairs_(tune::watchedPairs(session)) {
  run::RunOptions recorded = run;
  recorded.on_cycle = [&](double t, const std::vector<query::PairResult>& results) {
    Frame f;
    f.t = t;
    for (const scene::Object& o : session_.scene().objects()) f.X_WB.push_back(o.X_WB);
    for (const auto& m : session_.mechanisms()) f.q.insert(f.q.end(), m->q().begin(), m->q().end());
    for (const tune::WatchedPair& p : pairs_) {
      const query::PairResult& r = results[p.id.index()];
      f.uncertainty.push_back(session_.scene().pairUncertainty(p.id));
      f.distance.push_back(r.distance);
      f.clearance.push_back(r.distance - r.bound - f.uncertainty.back());
    }
    frames_.push_back(std::move(f));
  };
  run::runScene(session_, recorded);
  checkSpeeds();
}

void FrameByFrame::checkSpeeds() const {
  for (std::size_t i = 0; i + 1 < frames(); ++i)
    for (const tune::WatchedPair& p : pairs_) {
      double speed = 0.0;
      for (const std::size_t object : {p.part, p.link}) {
        const auto& sphere = session_.scene().objects()[object].spec.structure->bounding_sphere;
        const Transform &X_0 = frames_[i].X_WB[object], &X_1 = frames_[i + 1].X_WB[object];
        const double turn = Eigen::AngleAxisd(X_0.linear().transpose() * X_1.linear()).angle();
        speed += ((X_1 * sphere.centre - X_0 * sphere.centre).norm() + turn * sphere.radius) /
                 (frames_[i + 1].t - frames_[i].t);
      }
      ASSERT_LT(speed, kFastest) << frames_[i].t;
    }
}

double FrameByFrame::clearance(const Parts& parts, std::size_t frame) const {
  double least = kInfinity;
  for (std::size_t p = 0; p < pairs_.size(); ++p)
    if (std::count(parts.begin(), parts.end(), pairs_[p].body_part) > 0)
      least = std::min(least, frames_[frame].clearance[p]);
  return least;
}

Sampled FrameByFrame::atFrame(const Parts& parts, std::size_t frame) const {
  Sampled least;
  const Frame& f = frames_[frame];
  for (std::size_t p = 0; p < pairs_.size(); ++p)
    if (std::count(parts.begin(), parts.end(), pairs_[p].body_part) > 0)
      least.take({f.distance[p], f.clearance[p]});
  return least;
}

bool FrameByFrame::moves(std::size_t object, std::size_t frame) const {
  return frame + 1 < frames() &&
         frames_[frame].X_WB[object].matrix() != frames_[frame + 1].X_WB[object].matrix();
}

/// The shortest time in which the pace of the program falls evenly to 0 and no joint slows down faster than
/// it may: with a speed v of the program at any time that is still passed, v / time is at most the
/// deceleration. Tried in steps of 0.1 ms. Half of the time passes on the program meanwhile.
double FrameByFrame::brakingTime(std::size_t robot, double from) const {
  std::size_t first = 0;
  for (std::size_t r = 0; r < robot; ++r) first += session_.mechanisms()[r]->q().size();
  const std::size_t joints = session_.mechanisms()[robot]->q().size();
  std::size_t k = 0;
  while (k + 1 < frames() && frames_[k + 1].t <= from) ++k;
  double time = 0.0;
  for (; k + 1 < frames() && frames_[k].t <= from + 0.5 * time; ++k)
    for (std::size_t j = first; j < first + joints; ++j) {
      const double v = (frames_[k + 1].q[j] - frames_[k].q[j]) / (frames_[k + 1].t - frames_[k].t);
      while (std::abs(v) > options_.deceleration * time) time += 1e-4;
    }
  return time;
}

FrameByFrame::Drive FrameByFrame::stop(std::size_t robot, std::size_t frame) const {
  const double t0 = frames_[frame].t, end = frames_.back().t - t0;
  const double braking = brakingTime(robot, t0 + options_.reaction_time);
  Drive drive{{0.0}, {0.0}};
  double t = 0.0, s = 0.0, pace = 1.0;
  const auto go = [&](double dt, double slower) {
    t += dt;
    s += (pace - 0.5 * slower) * dt;
    pace -= slower;
    if (t > end) return;
    drive.t.push_back(t);
    drive.s.push_back(s);
  };
  while (t < options_.reaction_time && t <= end) go(std::min(kStep, options_.reaction_time - t), 0.0);
  while (pace > 0.0 && braking > 0.0 && t <= end) {
    const double dt = std::min(kStep, pace * braking);
    go(dt, dt < kStep ? pace : dt / braking);
  }
  return drive;
}

Transform FrameByFrame::personAt(std::size_t object, double t) const {
  std::size_t k = 0;
  while (k + 1 < frames() && frames_[k + 1].t <= t) ++k;
  if (k + 1 == frames()) return frames_[k].X_WB[object];
  const double share = (t - frames_[k].t) / (frames_[k + 1].t - frames_[k].t);
  const Transform &X_0 = frames_[k].X_WB[object], &X_1 = frames_[k + 1].X_WB[object];
  const Vector3d centre = session_.scene().objects()[object].spec.structure->bounding_sphere.centre;
  Transform X = Transform::Identity();
  X.linear() = Eigen::Quaterniond(X_0.linear())
                   .slerp(share, Eigen::Quaterniond(X_1.linear()))
                   .normalized()
                   .toRotationMatrix();
  X.translation() = (1.0 - share) * (X_0 * centre) + share * (X_1 * centre) - X.linear() * centre;
  return X;
}

FrameByFrame::PerPart FrameByFrame::sample(std::size_t frame, const std::vector<Drive>& drives) {
  PerPart least;
  const double t0 = frames_[frame].t, look = options_.limit + 0.01 + kSearch;
  std::vector<double> due(pairs_.size());
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const Drive& drive = drives[pairs_[p].robot];
    bool moved = false;
    for (std::size_t k = frame; k < frames() && frames_[k].t < t0 + drive.s.back() - kRounding; ++k)
      moved = moved || moves(pairs_[p].link, k);
    due[p] = moved ? (frames_[frame].clearance[p] - look) / kFastest : kInfinity;
  }
  for (std::size_t r = 0; r < drives.size(); ++r)
    for (std::size_t k = 0; k < drives[r].t.size(); ++k) {
      bool placed = false;
      const double t = drives[r].t[k];
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const tune::WatchedPair& pair = pairs_[p];
        if (pair.robot != r || t < due[p]) continue;
        if (!placed) session_.mechanisms()[r]->apply(t0 + drives[r].s[k], session_.scene());
        placed = true;
        const auto& objects = session_.scene().objects();
        query::PairResult result;
        query::queryPair({*objects[pair.part].spec.structure, personAt(pair.part, t0 + t)},
                         {*objects[pair.link].spec.structure, objects[pair.link].X_WB}, {}, scratch_, result);
        double uncertainty = frames_[frame].uncertainty[p];
        for (std::size_t f = frame + 1; f < frames() && frames_[f - 1].t < t0 + t; ++f)
          uncertainty = std::max(uncertainty, frames_[f].uncertainty[p]);
        const double certain = result.distance - result.bound - uncertainty;
        least[static_cast<std::size_t>(pair.body_part)].take({result.distance, certain});
        due[p] = t + std::max(0.0, certain - look) / kFastest;
      }
    }
  return least;
}

const FrameByFrame::PerPart& FrameByFrame::inStep(std::size_t frame) {
  const auto known = in_step_.find(frame);
  if (known != in_step_.end()) return known->second;
  if (frame + 1 == frames()) return in_step_[frame];
  const double duration = frames_[frame + 1].t - frames_[frame].t;
  const int steps = static_cast<int>(std::ceil(duration / kStep));
  Drive drive;
  for (int k = 0; k <= steps; ++k) drive.t.push_back(duration * k / steps);
  drive.s = drive.t;
  return in_step_[frame] = sample(frame, std::vector<Drive>(session_.mechanisms().size(), drive));
}

const FrameByFrame::PerPart& FrameByFrame::stoppedAt(std::size_t frame) {
  const auto known = stopped_.find(frame);
  if (known != stopped_.end()) return known->second;
  std::vector<Drive> drives;
  for (std::size_t r = 0; r < session_.mechanisms().size(); ++r) drives.push_back(stop(r, frame));
  return stopped_[frame] = sample(frame, drives);
}

Sampled FrameByFrame::of(const Parts& parts, const PerPart& all) {
  Sampled least;
  for (const humanmodel::BodyPart part : parts) least.take(all[static_cast<std::size_t>(part)]);
  return least;
}

Touch FrameByFrame::touch(const Sampled& s) const {
  if (s.certain > options_.limit + kTolerance + kSearch) return Touch::kNo;
  if (s.certain > options_.limit + kTolerance) return Touch::kNear;
  // What is not known at all counts as a touch.
  if (s.measured <= options_.limit - kPath || s.certain == -kInfinity) return Touch::kYes;
  return Touch::kUnsure;
}

Touch FrameByFrame::stopped(const Parts& parts, std::size_t frame) {
  return touch(of(parts, stoppedAt(frame)));
}

FrameByFrame::Judged FrameByFrame::judge(const Parts& parts, double margin, std::size_t first) {
  Judged judged;
  const auto missed = [&](Touch touch) {
    Count& count = judged.missed_stops;
    count.least += touch == Touch::kYes;
    count.safe_least += touch == Touch::kYes;
    count.most += touch == Touch::kYes || touch == Touch::kUnsure;
    count.safe_most += touch != Touch::kNo;
  };
  double stopped_until = -kInfinity;
  for (std::size_t i = first; i < frames(); ++i) {
    if (!(clearance(parts, i) < margin)) {
      // Nobody stops the robot before the next frame.
      missed(touch(of(parts, inStep(i))));
      continue;
    }
    ++judged.stops;
    missed(stopped(parts, i));
    const double told = frames_[i].t;
    Sampled without;  // the stop
    for (; i < frames() && clearance(parts, i) < margin; ++i) {
      without.take(atFrame(parts, i));
      without.take(of(parts, inStep(i)));
    }
    const Touch touched = touch(without);
    judged.false_stops.least += touched == Touch::kNo || touched == Touch::kNear;
    judged.false_stops.safe_least += touched == Touch::kNo;
    judged.false_stops.most += touched != Touch::kYes;
    judged.false_stops.safe_most += touched != Touch::kYes;
    const double last = frames_.back().t;
    const double until = i < frames() ? std::min(last, frames_[i].t + options_.restart_time) : last;
    judged.stopped_time += until - std::min(until, std::max(told, stopped_until));
    stopped_until = until;
    --i;  // the frame behind the intrusion is outside, too
  }
  return judged;
}

}  // namespace abstand::testing
