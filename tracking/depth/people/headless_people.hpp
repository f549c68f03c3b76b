// People whose heads are above the image, in plan view.
#pragma once

#include <array>

#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

/// Finds bodies that the upper border of the image cuts off: as broad as a trunk there, above enough of a
/// body, with free space beside. Furniture may look so, too: it must have moved by kMoved, as people do,
/// since it appeared, and have been seen in kImages consecutive images. Not shared between threads; find()
/// does not allocate or throw.
class HeadlessPeople {
 public:
  /// After plan.join().
  void find(const PlanView& plan);
  /// Middles of the bodies in this image.
  std::span<const PlanView::Place> places() const { return {places_.data(), count_}; }

  static constexpr int kImages = 10;
  static constexpr std::size_t kMax = 8;      ///< bodies at a time
  static constexpr double kSamePlace = 0.15;  ///< m, between two images
  /// m. People who stand sway by 0.01 and more; the middle of a thing that stands varies by 0.002 (noise of
  /// some thousand pixels).
  static constexpr double kMoved = 0.008;

 private:
  struct Candidate {
    PlanView::Place place{PlanView::Place::Zero()}, from{PlanView::Place::Zero()};
    int images{0};
    bool moved{false};
  };
  std::array<Candidate, kMax> last_{}, now_{};
  std::size_t last_count_{0}, count_{0};
  std::array<PlanView::Place, kMax> places_{};
};

}  // namespace abstand::tracking
