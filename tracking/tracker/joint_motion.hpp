// Uncertainty of joints that move unevenly.
#pragma once

#include <array>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

/// A joint of a visible segment is the less certain the more its velocity changes in the fit: between two
/// images a limb moves farther than its thickness and may be fitted to something else, and a fit that is
/// wrong jumps. Even motion is predicted and counts nothing. The standard deviation is kTime times the change
/// of velocity from one image to the next (m/s), the largest of the past, each decayed with kDecay; before
/// the first image, it was kUnknown. With kTime at least 0.994 of the raw errors of each clip that it was
/// chosen with are within reach, without the term 0.983 (docs/tracking-uncertainty.md). Does not allocate or
/// throw.
class JointMotion {
 public:
  using Spreads = std::array<double, humanmodel::kJointCount>;

  static constexpr double kTime = 0.015;  ///< s
  static constexpr double kDecay = 0.3;   ///< s, after which a change counts e times less
  static constexpr double kMaxGap = 0.2;  ///< s; the velocity over longer gaps is unknown
  /// m/s. With 0, 0.990 of the raw errors of a clip of fast punches (`boxing from the side`) are within
  /// reach, with 1 0.994, with 3 all, but the median of reach / error of all hard captures rises from 3.7
  /// to 4.0.
  static constexpr double kUnknown = 1.0;

  /// The joints at `t` (s). A frame at the time of the last one replaces it and moves nothing.
  void see(double t, const humanmodel::SkeletonFrame& frame);
  /// The person was lost: the next frame is the first.
  void forget();
  /// After see(): standard deviation (m) of each joint along its worst axis.
  const Spreads& spread() const { return spread_; }

 private:
  using Vectors = std::array<Vector3d, humanmodel::kJointCount>;
  Vectors last_{}, velocity_{};  ///< m, m/s
  double last_t_{kNaN};          ///< s; NaN: no frame
  bool moved_{false};            ///< velocity_ is known
  Spreads spread_{};
};

}  // namespace abstand::tracking
