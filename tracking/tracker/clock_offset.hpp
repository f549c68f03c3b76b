// Difference of the clocks of two recordings of one person.
#pragma once

#include <span>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// Estimate of a clock's offset.
struct ClockOffset {
  double offset{0.0};  ///< s, to be added to the times of the second recording
  /// Whether the movement decides: at 0.1 s beside the offset, joints lie at least kDecides times as far
  /// apart (robust mean square). Otherwise `offset` is the best guess.
  bool decided{false};
  double apart{0.0};    ///< m, robust RMS distance of the joints at the offset, constant distances taken off
  double at_zero{0.0};  ///< m, likewise, with equal clocks; infinite if they have too little in common then
  double overlap{0.0};  ///< s of both recordings compared there

  /// Whether the movement shows that the clocks differ: joints lie kDecides times as far apart with equal
  /// ones.
  bool refutesZero() const;

  static constexpr double kDecides = 1.3;
  static constexpr double kFarthest = 5.0;  ///< s, search range on both sides
};

/// Compares the joints of the two, in one world, at offsets up to kFarthest, and takes the one with the
/// smallest distances. A constant distance of a joint, as from a badly calibrated camera, does not count.
/// Needs an overlap of one second and of 0.6 of the shorter one. May allocate.
ClockOffset estimateClockOffset(std::span<const humanmodel::SkeletonFrame> first,
                                std::span<const humanmodel::SkeletonFrame> second);

}  // namespace abstand::tracking
