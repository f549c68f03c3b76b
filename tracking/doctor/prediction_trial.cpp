#include "tracking/doctor/prediction_trial.hpp"

#include <algorithm>

#include "core/math/quantile.hpp"
#include "core/safety/motion_prediction.hpp"

namespace abstand::tracking {
namespace {

/// The measured positions of one joint.
struct Trajectory {
  std::vector<double> t;
  std::vector<Vector3d> p;
};

Trajectory trajectoryOf(const std::vector<humanmodel::SkeletonFrame>& frames, std::size_t joint) {
  Trajectory trajectory;
  for (const humanmodel::SkeletonFrame& f : frames) {
    if (f.state[joint] != humanmodel::JointState::kTracked ||
        (!trajectory.t.empty() && !(f.t > trajectory.t.back())))
      continue;
    trajectory.t.push_back(f.t);
    trajectory.p.push_back(f.p[joint]);
  }
  return trajectory;
}

/// Position at `t` by linear interpolation; nullopt in a gap or outside of the range.
std::optional<Vector3d> positionAt(const Trajectory& trajectory, double t, double longest_gap) {
  const auto after = std::lower_bound(trajectory.t.begin(), trajectory.t.end(), t);
  if (after == trajectory.t.end() || after == trajectory.t.begin()) return std::nullopt;
  const auto i = static_cast<std::size_t>(after - trajectory.t.begin());
  const double step = trajectory.t[i] - trajectory.t[i - 1];
  if (step > longest_gap) return std::nullopt;
  return trajectory.p[i - 1] + (t - trajectory.t[i - 1]) / step * (trajectory.p[i] - trajectory.p[i - 1]);
}

}  // namespace

std::vector<PredictionTrial> tryPredictions(const Recording& recording, const safety::MotionBounds& bounds,
                                            std::span<const double> ahead) {
  bounds.validate();
  const safety::PredictionOptions options;
  std::vector<PredictionTrial> trials(ahead.size());
  std::vector<std::vector<double>> still(ahead.size()), guess(ahead.size());
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const Trajectory trajectory = trajectoryOf(recording.frames, j);
    safety::MotionPrediction prediction(options);
    for (std::size_t i = 0; i < trajectory.t.size(); ++i) {
      Transform X = Transform::Identity();
      X.translation() = trajectory.p[i];
      prediction.add(trajectory.t[i], X);
      for (std::size_t h = 0; h < ahead.size(); ++h) {
        const auto place = positionAt(trajectory, trajectory.t[i] + ahead[h], options.longest_gap);
        if (!place) continue;
        const double error = (*place - trajectory.p[i]).norm();
        still[h].push_back(error);
        guess[h].push_back((*place - prediction.at(ahead[h]).translation()).norm());
        const geometry::EnclosingSphere reach =
            safety::reachAt(trajectory.p[i], prediction.velocity().linear, bounds, ahead[h]);
        trials[h].outside += (*place - reach.centre).norm() > reach.radius ? 1 : 0;
        trials[h].speed_needed = std::max(trials[h].speed_needed, error / ahead[h]);
      }
    }
  }
  const auto mean = [](const std::vector<double>& v) {
    double sum = 0.0;
    for (const double x : v) sum += x;
    return sum / static_cast<double>(v.size());
  };
  for (std::size_t h = 0; h < ahead.size(); ++h) {
    PredictionTrial& trial = trials[h];
    trial.ahead = ahead[h];
    trial.places = still[h].size();
    if (still[h].empty()) continue;
    trial.still_mean = mean(still[h]);
    trial.guess_mean = mean(guess[h]);
    trial.guess_max = *std::max_element(guess[h].begin(), guess[h].end());
    trial.still_p95 = nearestQuantile(std::move(still[h]), 0.95);
    trial.guess_p95 = nearestQuantile(std::move(guess[h]), 0.95);
  }
  return trials;
}

}  // namespace abstand::tracking
