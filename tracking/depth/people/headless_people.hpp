// People whose heads are not seen as heads, in plan view.
#pragma once

#include <array>

#include "tracking/depth/people/repeated_places.hpp"

namespace abstand::tracking {

/// Finds bodies that the upper border of the image cuts off: as broad as a trunk there, above enough of a
/// body, with free space beside; and whole bodies 1.2 to 2.45 m high with a trunk with free space beside,
/// whatever their highest part is: of people whose hands are at or above the head, that is no head. Furniture
/// may look so, too: it must have moved by kMoved, as people do, since it appeared, and have been seen in
/// kImages consecutive images. Not shared between threads; find() does not allocate or throw.
class HeadlessPeople {
 public:
  /// After plan.join().
  void find(const PlanView& plan);
  /// Middles of the bodies in this image.
  std::span<const PlanView::Place> places() const { return {places_.data(), count_}; }

  static constexpr int kImages = 10;
  /// m. People who stand sway by 0.01 and more; the middle of a thing that stands varies by 0.002 (noise of
  /// some thousand pixels).
  static constexpr double kMoved = 0.008;

 private:
  RepeatedPlaces found_;
  std::array<PlanView::Place, RepeatedPlaces::kMax> places_{};
  std::size_t count_{0};
};

}  // namespace abstand::tracking
