// What has been computed of the recording so far.
#include "ui/model/run_history.hpp"

#include <algorithm>

namespace abstand::ui {

void RunHistory::open(const view::SceneOutline& outline) {
  distance_ = FrameSeries(outline.start, outline.end, outline.frame_period, Keep::kSmallest);
  force_ = FrameSeries(outline.start, outline.end, outline.frame_period, Keep::kLargest);
  start_ = outline.start;
  end_ = outline.end;
  period_ = outline.frame_period;
  torqueOf(-1);
}

void RunHistory::torqueOf(int joint) {
  joint_ = joint;
  for (FrameSeries& series : torques_) series = FrameSeries(start_, end_, period_, Keep::kLargest);
}

void RunHistory::add(const view::SceneSnapshot& snapshot) {
  if (joint_ < 0 || static_cast<std::size_t>(joint_) >= snapshot.joint_torques.size()) return;
  const view::TorqueParts& parts = snapshot.joint_torques[static_cast<std::size_t>(joint_)];
  for (std::size_t k = 0; k < view::kTorqueParts; ++k) torques_[k].add(snapshot.t, parts[k]);
}

void RunHistory::add(const std::vector<view::PlotSample>& samples) {
  for (const view::PlotSample& sample : samples) {
    distance_.add(sample.t, sample.min_distance);
    force_.add(sample.t, sample.peak_force);
    if (joint_ >= 0) continue;
    for (std::size_t k = 0; k < view::kTorqueParts; ++k) torques_[k].add(sample.t, sample.peak_torque[k]);
  }
}

bool RunHistory::contact(std::size_t frame) const {
  const double t = distance_.time(frame);
  return distance_.value(frame) <= 0.0 || force_.at(t) > 0.0;
}

std::optional<double> RunHistory::nextContact(double t) const {
  for (std::size_t f = 0; f < distance_.size(); ++f)
    if (distance_.time(f) > t + 0.5 * distance_.period() && begins(f)) return distance_.time(f);
  return {};
}

std::optional<double> RunHistory::previousContact(double t) const {
  for (std::size_t f = distance_.size(); f-- > 0;)
    if (distance_.time(f) < t - 0.5 * distance_.period() && begins(f)) return distance_.time(f);
  return {};
}

}  // namespace abstand::ui
