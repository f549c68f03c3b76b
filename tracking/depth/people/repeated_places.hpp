// Places in plan view that are found again from image to image.
#pragma once

#include <array>
#include <span>

#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

/// Follows what is found in consecutive images: a place nearer than kSamePlace to one of the last image is
/// the same one, that of the longest row of images where there are several. Not shared between threads; no
/// allocation, no throw.
class RepeatedPlaces {
 public:
  struct Entry {
    PlanView::Place place{PlanView::Place::Zero()};
    PlanView::Place first{PlanView::Place::Zero()};  ///< where it was found at first
    int images{1};                                   ///< consecutive ones, this one included
    double since{0.0};                               ///< s, time of the first of them
    bool moved{false};                               ///< was farther than `far` from `first`
  };
  static constexpr std::size_t kMax = 8;      ///< places in an image
  static constexpr double kSamePlace = 0.15;  ///< m, between two images

  /// A new image.
  void start() {
    last_ = now_;
    last_count_ = count_;
    count_ = 0;
  }
  bool full() const { return count_ == kMax; }
  /// Not if full(). `far`: m; `t`: s.
  const Entry& add(const PlanView::Place& place, double far = kInfinity, double t = 0.0) {
    Entry entry{place, place, 1, t, false};
    for (const Entry& before : std::span(last_).first(last_count_))
      if ((before.place - place).norm() < kSamePlace && before.images >= entry.images)
        entry = {place, before.first, before.images + 1, before.since, before.moved};
    entry.moved = entry.moved || (place - entry.first).norm() > far;
    return now_[count_++] = entry;
  }

 private:
  std::array<Entry, kMax> last_{}, now_{};
  std::size_t last_count_{0}, count_{0};
};

}  // namespace abstand::tracking
