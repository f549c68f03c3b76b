// What has been computed of the recording so far.
#include "ui/model/run_history.hpp"

#include <algorithm>

namespace abstand::ui {

void RunHistory::open(const SceneOutline& outline) {
  distance_ = FrameSeries(outline.start, outline.end, outline.frame_period, Keep::kSmallest);
  force_ = FrameSeries(outline.start, outline.end, outline.frame_period, Keep::kLargest);
  effort_ = FrameSeries(outline.start, outline.end, outline.frame_period, Keep::kLargest);
}

void RunHistory::add(const std::vector<PlotSample>& samples) {
  for (const PlotSample& sample : samples) {
    distance_.add(sample.t, sample.min_distance);
    force_.add(sample.t, sample.peak_force);
    effort_.add(sample.t, sample.peak_effort);
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
