// Times at which one of several cameras cannot be trusted.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// What is wrong with a camera, from `since` to `until` (s; infinite: until the end).
struct CameraFault {
  enum class Kind : std::uint8_t {
    kMoved,  ///< CameraWatch has noticed it
    kHangs,  ///< repeats an image
    kApart,  ///< sees people elsewhere than the others do: it was pushed, or its pose is wrong
    kLate,   ///< sees people move later than the others do
  };
  Kind kind{Kind::kMoved};
  std::size_t camera{0};
  double since{0.0}, until{kInfinity};
  double apart{0.0};   ///< m, of kApart: distance of the places of one person
  double late{0.0};    ///< s, of kLate; negative: early
  bool certain{true};  ///< of kApart: it is this camera; otherwise it may be one that is used

  /// The state of a camera that sees people apart is known from medians over time: somewhat longer.
  bool holds(double t) const {
    const double blurred = kind == Kind::kApart ? kBlurred : 0.0;
    return t >= since - blurred && t < until + blurred;
  }
  static constexpr double kBlurred = 0.1;  ///< s, three images
  /// Whether its images are not used.
  bool leavesOut() const { return kind != Kind::kLate; }
};

/// Whether the images of a camera can be used at `t` (s).
inline bool isUsable(std::span<const CameraFault> faults, std::size_t camera, double t) {
  for (const CameraFault& fault : faults)
    if (fault.camera == camera && fault.leavesOut() && fault.holds(t)) return false;
  return true;
}

/// m: how far all joints may be off at `t` (s), because a camera that is used may be the one that is wrong.
inline double doubtAt(std::span<const CameraFault> faults, double t) {
  double most = 0.0;
  for (const CameraFault& fault : faults)
    if (fault.kind == CameraFault::Kind::kApart && !fault.certain && fault.holds(t))
      most = std::max(most, fault.apart);
  return most;
}

/// s: the largest difference in time of a camera that is late or early at `t` (s).
inline double lateAt(std::span<const CameraFault> faults, double t) {
  double most = 0.0;
  for (const CameraFault& fault : faults)
    if (fault.kind == CameraFault::Kind::kLate && fault.holds(t)) most = std::max(most, std::abs(fault.late));
  return most;
}

}  // namespace abstand::tracking
