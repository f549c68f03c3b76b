// How long the cycles of the running session took.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/cycle_statistics.hpp"
#include "core/view/snapshot.hpp"
#include "ui/model/frame_series.hpp"

namespace abstand::ui {

/// Wall times of all cycles that were played since open() or clear(); those of seeks and steps, which start
/// cold, do not count. GUI thread only.
class CycleLog {
 public:
  /// What a cycle has at the rate of the loop, 1 kHz, s.
  static constexpr double kDeadline = 1e-3;

  struct Longest {
    double t{0.0};         ///< s, scene time
    double seconds{0.0};   ///< wall time
    int nearest_pair{-1};  ///< the nearest pair of the scene then, -1 without pairs
  };

  void open(const view::SceneOutline& outline);
  void add(const std::vector<view::PlotSample>& samples);
  /// Forgets all; the times of the scene stay.
  void clear();

  /// Its overruns are cycles above kDeadline.
  const scene::CycleStatistics& statistics() const { return statistics_; }
  /// Cycles longer than the step that the loop had chosen.
  long late() const { return late_; }
  /// None before anything was played.
  const std::optional<Longest>& longest() const { return longest_; }
  /// Longest cycle of each frame, s; a frame that is played again takes the new time.
  const FrameSeries& series() const { return series_; }

 private:
  scene::CycleStatistics statistics_{kDeadline};
  FrameSeries series_;
  std::optional<Longest> longest_;
  long late_{0};
  double start_{0.0}, end_{0.0}, period_{1.0};
};

}  // namespace abstand::ui
