// Which way a person faces when first seen.
#pragma once

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// Facing direction of a person when first seen. Who lies on the front faces away: cameras are above people
/// who lie.
struct Facing {
  bool away{false};    ///< the back is to the camera
  bool given{false};   ///< set by the user
  bool lies{false};    ///< in the images that were compared
  bool kneels{false};  ///< a body that faces either way kneels in more than half of them
  /// More than half of them show neither the head nor the feet, or somebody who bends to the floor.
  bool shows_little{false};
  /// Of the first images, facing away over facing the camera: the ratio of the fit costs, of people who do
  /// not lie with the factors of FacingTrial; NaN: not compared.
  double ratio{kNaN};
  /// Ratios beyond which one direction is certain, and below the inverse of which the other one is
  /// (docs/tracking.md has measured ratios). In between the images do not decide: the likelier direction is
  /// assumed and reported as undecided.
  static constexpr double kSure = 1.5, kSureLying = 1.15;
  /// Likewise that people face away. Of 180 clips drawn at random, a body that wrongly faced the camera had a
  /// ratio of 1.40, one that wrongly faced away 0.76.
  static constexpr double kSureAway = 1.25;
  /// Likewise that people on the knees face away: with coarse images, that of 5 m, the ratio of those who
  /// face the camera was down to 0.79.
  static constexpr double kSureKneelingAway = 1.5;
  /// Likewise if they show little: a trunk with an arm faced the wrong way at 2.5, a bent person at 1.6.
  static constexpr double kSureOfLittle = 4.0;
  double sure() const { return lies ? kSureLying : shows_little ? kSureOfLittle : kSure; }
  double sureAway() const {
    if (lies || shows_little) return sure();
    return kneels ? kSureKneelingAway : kSureAway;
  }
  bool decided() const { return given || ratio < 1.0 / sureAway() || ratio > sure(); }
  /// Whether `ratio` is of the other direction.
  bool contradicts() const { return away ? ratio > 1.0 : ratio < 1.0; }
  /// Of a person who lies: sets `lies`, `away` and `ratio` from two ratios of costs, facing away over facing
  /// the camera: `turning`, of turned poses, and `searching`, of searches from both sides; NaN: none. A
  /// turned pose has lost what a search would find: if they disagree, `ratio` is 1, else the less certain of
  /// both. The likelier side is assumed.
  void decideLying(double turning, double searching);
};

}  // namespace abstand::tracking
