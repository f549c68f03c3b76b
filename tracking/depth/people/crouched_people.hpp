// People who squat or bend, whose heads are lower than their backs, in plan view.
#pragma once

#include <array>

#include "tracking/depth/people/repeated_places.hpp"

namespace abstand::tracking {

/// Finds bodies that are lower than somebody who stands, as large as a person, and move as no thing does:
/// either most of the surface has not settled (PlanView::Cell) for kUnsettled, or what has settled drifts, in
/// kImages consecutive images. Even somebody who keeps still drifts by 4 to 20 mm in a second, a thing by
/// 0.2 mm z^2 at z (m), the noise of a Kinect. Not shared between threads; find() does not allocate or throw.
class CrouchedPeople {
 public:
  /// After plan.join(), at `t` (s). `is_disturbed(place)`: whether somebody may move or hide things there;
  /// such bodies are not found.
  template <class IsDisturbed>
  void find(double t, const PlanView& plan, const IsDisturbed& is_disturbed) {
    unsettled_.start();
    drifting_.start();
    count_ = 0;
    for (std::size_t k = 0; k < plan.components() && count_ < places_.size(); ++k) {
      if (unsettled_.full() || drifting_.full()) break;
      const Body body = bodyOf(plan, plan.component(k));
      if (!(body.unsettled || body.drifts) || is_disturbed(body.middle)) continue;
      bool is_person = false;
      if (body.unsettled) is_person = t - unsettled_.add(body.middle, kInfinity, t).since >= kUnsettled;
      if (body.drifts) is_person = drifting_.add(body.middle).images >= kImages || is_person;
      if (is_person) places_[count_++] = body.middle;
    }
  }
  /// Middles of the bodies in this image.
  std::span<const PlanView::Place> places() const { return {places_.data(), count_}; }

  static constexpr double kUnsettled = 1.0;  ///< s
  static constexpr int kImages = 10;

 private:
  struct Body {
    PlanView::Place middle{PlanView::Place::Zero()};  ///< m
    bool unsettled{false}, drifts{false};             ///< both false: nobody
  };
  static Body bodyOf(const PlanView& plan, std::span<const int> cells);

  RepeatedPlaces unsettled_, drifting_;
  std::array<PlanView::Place, RepeatedPlaces::kMax> places_{};
  std::size_t count_{0};
};

}  // namespace abstand::tracking
