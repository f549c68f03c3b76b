// Times at which two cameras see one person at different places.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// One person at one time, tracked with each of two cameras alone (middleJoints()).
struct SeenTwice {
  double t{0.0};  ///< s
  humanmodel::SkeletonFrame first, second;
  Vector3d off{Vector3d::Zero()};  ///< m, offsetBetween() them
};

/// From `since` to `until` (s; infinite: until the end, -infinite: from the start), the places differ by
/// `distance` (m, nearly the largest).
struct ApartSpan {
  double since{-kInfinity}, until{kInfinity};
  double distance{0.0};

  /// m. Places that two calibrated cameras at right angles give were 0.01 to 0.055 apart; a turn of 3 degrees
  /// at 2.8 m is 0.15.
  static constexpr double kApart = 0.09;  ///< of heights, 0.10 more
  bool holdsWith(const ApartSpan& other) const { return since < other.until && other.since < until; }
};

/// Times in order. The median over 0.5 s is above ApartSpan::kApart for 0.5 s or longer; it ends when it is
/// below for as long. Times without the person beside it belong to it. May allocate.
std::vector<ApartSpan> apartSpans(std::span<const SeenTwice> seen);

/// Which of the two was pushed at `t` (s): the bodies that it sees jump there, and those of the other one go
/// on as before. 0 or 1; nullopt: not known, as of a slow movement. May allocate.
std::optional<int> whichJumped(std::span<const SeenTwice> seen, double t);

}  // namespace abstand::tracking
