// People who lie on the floor, in plan view.
#pragma once

#include <array>

#include "tracking/depth/people/repeated_places.hpp"

namespace abstand::tracking {

/// Finds components with the outline of an adult who lies: low, as long as a person and as broad, and not of
/// one height, as a pallet or a mat is. Its middle must stay in one place (RepeatedPlaces) in kImages
/// consecutive images. Not shared between threads; find() does not allocate or throw.
class LyingPeople {
 public:
  /// After plan.join().
  void find(const PlanView& plan);
  /// Middles of the bodies that were found in kImages images, the last one included.
  std::span<const PlanView::Place> places() const { return {places_.data(), count_}; }

  static constexpr int kImages = 10;

 private:
  RepeatedPlaces found_;
  std::array<PlanView::Place, RepeatedPlaces::kMax> places_{};
  std::size_t count_{0};
};

}  // namespace abstand::tracking
