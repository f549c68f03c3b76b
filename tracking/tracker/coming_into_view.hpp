// People who walk into an image.
#pragma once

#include <span>
#include <vector>

#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// m^2 of a person's surface that the cameras see, all images together.
double visibleArea(std::span<const PersonImage> images);

/// Follows how much of a person is seen in the first kLongest seconds. A body that is searched for when only
/// an arm is in the image stays wrong (docs/tracking-views.md, *From the first image*). One thread. Allocates
/// in these seconds.
class ComingIntoView {
 public:
  static constexpr double kLongest = 2.0;  ///< s

  /// `t` (s) increases; `images`: one of each camera that sees the person.
  void see(double t, std::span<const PersonImage> images);

  /// Whether the sides of all images cut the person off, of whom more and more is seen; also if it is not
  /// known yet. False after kLongest.
  bool isGrowing() const;
  /// s, of the first images that are not cut off so, or show nearly as much as any before `end` (s); NaN
  /// without images.
  double start(double end = kInfinity) const;

 private:
  struct Seen {
    double t;     // s
    double area;  // m^2
    bool is_cut;  // off by the sides of all images
  };
  std::vector<Seen> seen_;
  bool has_ended_{false};  ///< after kLongest
};

}  // namespace abstand::tracking
