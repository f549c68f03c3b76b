// What has been computed of the recording so far, over its whole time.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/frame_series.hpp"
#include "ui/model/pair_class.hpp"

namespace abstand::ui {

/// The series that the time strip and the plots draw. Distances and touches do not depend on margins. Forces
/// and torques do: when a margin changes, those of before are moved to the series of earlier margins, until
/// their frames are played again. GUI thread only.
class RunHistory {
 public:
  void open(const view::SceneOutline& outline);
  void add(const std::vector<view::PlotSample>& samples);

  /// m, of all pairs.
  const FrameSeries& distance() const { return distances_.all; }
  /// m, of one class.
  const FrameSeries& distanceOf(PairClass of) const { return distances_.of[static_cast<std::size_t>(of)]; }
  /// Classes of which the scene has pairs, people and robots first.
  const std::vector<PairClass>& classes() const { return classes_; }
  /// m: of people and robots, where the scene has such pairs; else of all.
  const FrameSeries& firstDistance() const;

  /// N: of pairs that touch, and of pairs that are only inside their margins, under the present margins.
  const FrameSeries& contactForce() const { return forces_.contact; }
  const FrameSeries& virtualForce() const { return forces_.apart; }
  /// N: the larger of the two, under margins that are not those of now.
  const FrameSeries& earlierForce() const { return forces_.earlier; }
  /// Of the joint that torqueOf() named last: what acts on it, with its sign; of all joints: the largest
  /// magnitudes. In the order of TorqueParts; contact and reaction under the present margins.
  const std::array<FrameSeries, view::kTorqueParts>& torques() const { return torques_; }
  /// That of contacts under margins that are not those of now.
  const FrameSeries& earlierTorque() const { return earlier_torque_; }
  /// Something was computed under margins that are not those of now.
  bool hasEarlier() const { return has_earlier_; }
  /// Joint of the outline, or -1 for the largest of all. Starts the series anew.
  void torqueOf(int joint);
  /// Of the chosen joint; the largest of all come with the samples.
  void add(const view::SceneSnapshot& snapshot);

  /// Grows with every change of the series that the strip shows.
  long revision() const {
    return distances_.all.revision() + forces_.apart.revision() + forces_.earlier.revision();
  }
  /// In [from, to] (s) something touched, whatever the margins.
  bool touched(double from, double to) const;
  /// Something was inside its margin and did not touch: a margin of now, or one of before.
  bool wasInside(double from, double to) const { return forces_.apart.between(from, to).high > 0.0; }
  bool wasInsideEarlier(double from, double to) const { return forces_.earlier.between(from, to).high > 0.0; }

  /// Time at which the next contact or intrusion into a margin of now after t begins, or the one before t
  /// began, among what has been computed. `touches`, `inside`: of which of the two.
  std::optional<double> nextContact(double t, bool touches = true, bool inside = true) const;
  std::optional<double> previousContact(double t, bool touches = true, bool inside = true) const;

 private:
  bool begins(std::size_t frame, bool touches, bool inside) const;
  void retire();

  struct {
    FrameSeries all;
    std::array<FrameSeries, view::kPairClasses> of;
  } distances_;
  struct {
    FrameSeries contact, apart, earlier;
  } forces_;
  FrameSeries touch_;  ///< 1: something touches, 0: nothing does
  std::array<FrameSeries, view::kTorqueParts> torques_;
  FrameSeries earlier_torque_;
  std::vector<PairClass> classes_;
  double start_{0.0}, end_{0.0}, period_{1.0};
  double fresh_from_{0.0}, fresh_to_{-1.0};  ///< s, of what was computed under the present margins
  long margin_edits_{0};                     ///< PlotSample::margin_edits of the last sample
  bool has_earlier_{false};
  int joint_{-1};
};

}  // namespace abstand::ui
