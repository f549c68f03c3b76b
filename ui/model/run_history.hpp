// What has been computed of the recording so far, over its whole time.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/frame_series.hpp"

namespace abstand::ui {

/// The series that the time strip and the plots draw. GUI thread only.
class RunHistory {
 public:
  void open(const view::SceneOutline& outline);
  void add(const std::vector<view::PlotSample>& samples);

  const FrameSeries& distance() const { return distance_; }
  const FrameSeries& force() const { return force_; }
  /// Of the joint that torqueOf() named last: what acts on it, with its sign; of all joints: the largest
  /// magnitudes. In the order of TorqueParts.
  const std::array<FrameSeries, view::kTorqueParts>& torques() const { return torques_; }
  /// Joint of the outline, or -1 for the largest of all. Starts the series anew.
  void torqueOf(int joint);
  /// Of the chosen joint; the largest of all come with the samples.
  void add(const view::SceneSnapshot& snapshot);

  /// Time at which the next contact after t begins, or the one before t began, among what has been computed.
  std::optional<double> nextContact(double t) const;
  std::optional<double> previousContact(double t) const;

 private:
  bool contact(std::size_t frame) const;
  bool begins(std::size_t frame) const { return contact(frame) && (frame == 0 || !contact(frame - 1)); }

  FrameSeries distance_, force_;
  std::array<FrameSeries, view::kTorqueParts> torques_;
  double start_{0.0}, end_{0.0}, period_{1.0};
  int joint_{-1};
};

}  // namespace abstand::ui
