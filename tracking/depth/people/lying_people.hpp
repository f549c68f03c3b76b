// People who lie on the floor, in plan view.
#pragma once

#include <array>

#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

/// Finds components with the outline of an adult who lies: low, as long as a person and as broad, and not of
/// one height, as a pallet or a mat is. Its middle must stay in one place (kSamePlace) in kImages consecutive
/// images. Not shared between threads; find() does not allocate or throw.
class LyingPeople {
 public:
  /// After plan.join().
  void find(const PlanView& plan);
  /// Middles of the bodies that were found in kImages images, the last one included.
  std::span<const PlanView::Place> places() const { return {places_.data(), count_}; }

  static constexpr int kImages = 10;
  static constexpr std::size_t kMax = 8;      ///< bodies at a time
  static constexpr double kSamePlace = 0.15;  ///< m, between two images

 private:
  struct Candidate {
    PlanView::Place place{PlanView::Place::Zero()};
    int images{0};
  };
  std::array<Candidate, kMax> last_{}, now_{};
  std::size_t last_count_{0}, count_{0};
  std::array<PlanView::Place, kMax> places_{};
};

}  // namespace abstand::tracking
