// Places of limbs that explain an image about as well as the fitted ones.
#pragma once

#include <span>

#include "tracking/tracker/limb_search.hpp"

namespace abstand::tracking {

/// The search for limbs tries about 130 places of each limb in each image. Where one of them that is far from
/// the fitted place explains the image nearly as well, the limb may be there: the image does not tell.
/// Distances to such places count for some time, as they are tried at random. Does not allocate or throw.
class LimbAlternatives {
 public:
  using Distances = std::array<double, humanmodel::kJointCount>;  ///< m

  /// A place counts if it costs at most this times as much as the fitted one, or more by as much as that is
  /// for a body of kDoubtfulCost: how well other parts fit tells nothing of a limb. Places that are tried are
  /// not refined: their cost is an upper bound.
  static constexpr double kAlike = 1.2;
  static constexpr double kDoubtfulCost = 6e-4;  ///< m^2, of a body that hardly fits
  static constexpr double kFar = 0.15;   ///< m; the vicinity of the fitted place always costs about as much
  static constexpr double kDecay = 0.5;  ///< s, after which a distance counts e times less

  /// Begins the image at `t` (s). An image at the time of the last one adds to it.
  void begin(double t);
  /// What was tried for kLimbs[`limb`] in it, while the fitted limb has `cost` (m^2) and the body is at
  /// `X_WS`.
  void add(std::size_t limb, std::span<const LimbTry> tries, double cost, const RigPlacement& X_WS);
  /// The person was lost.
  void forget();
  /// Of each joint from elbow and knee outwards to its farthest place that counts; 0 for none and for others.
  const Distances& distance() const { return distance_; }

 private:
  Distances distance_{};
  double last_t_{kNaN};  ///< s; NaN: no image
};

}  // namespace abstand::tracking
