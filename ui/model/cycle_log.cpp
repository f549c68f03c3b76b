#include "ui/model/cycle_log.hpp"

namespace abstand::ui {

void CycleLog::open(const view::SceneOutline& outline) {
  start_ = outline.start;
  end_ = outline.end;
  period_ = outline.frame_period;
  clear();
}

void CycleLog::clear() {
  statistics_.clear();
  longest_.reset();
  late_ = 0;
  series_ = FrameSeries(start_, end_, period_, Keep::kLargest);
}

void CycleLog::add(const std::vector<view::PlotSample>& samples) {
  for (const view::PlotSample& sample : samples) {
    if (!sample.played) continue;
    statistics_.add(sample.cycle_s);
    series_.add(sample.t, sample.cycle_s);
    if (sample.cycle_s > sample.step_s) ++late_;
    if (!longest_ || sample.cycle_s > longest_->seconds)
      longest_ = Longest{sample.t, sample.cycle_s, sample.nearest_pair};
  }
}

}  // namespace abstand::ui
