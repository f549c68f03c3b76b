// What has been computed of the recording so far, over its whole time.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/snapshot.hpp"
#include "ui/model/frame_series.hpp"

namespace abstand::ui {

/// The series that the time strip and the plots draw. GUI thread only.
class RunHistory {
 public:
  void open(const SceneOutline& outline);
  void add(const std::vector<PlotSample>& samples);

  const FrameSeries& distance() const { return distance_; }
  const FrameSeries& force() const { return force_; }
  const FrameSeries& effort() const { return effort_; }

  /// Time at which the next contact after t begins, or the one before t began, among what has been computed.
  std::optional<double> nextContact(double t) const;
  std::optional<double> previousContact(double t) const;

 private:
  bool contact(std::size_t frame) const;
  bool begins(std::size_t frame) const { return contact(frame) && (frame == 0 || !contact(frame - 1)); }

  FrameSeries distance_, force_, effort_;
};

}  // namespace abstand::ui
