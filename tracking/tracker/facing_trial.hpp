// Comparison of a person's facing directions, image by image.
#pragma once

#include <algorithm>
#include <cstddef>

#include "tracking/tracker/facing.hpp"
#include "tracking/tracker/facing_evidence.hpp"

namespace abstand::tracking {

/// Adds what the images say of two bodies that follow the same person, one that faced the camera at first and
/// one that faced away: motion refutes the wrong one. The ratio is that of the costs of both, times two
/// factors for what is little of an image but tells the front (docs/tracking-views.md has measured values):
/// toes that only the body that faces the camera explains, and walking forward. Toes do not count in images
/// in which the other body kneels, nor if these are more than half of all: its feet point to the camera, too.
/// Toes that are not seen tell nothing, as cameras lose them in the floor. One thread. Allocates nothing,
/// does not throw.
class FacingTrial {
 public:
  /// Images that can decide; fewer, if the ratio of the costs is beyond kClear; and how many are compared.
  static constexpr std::size_t kMinImages = 30, kFewImages = 15, kMaxImages = 300;
  static constexpr double kClear = 1.5;
  /// Images after which a decision is final, and the ratio beyond which it is after kMinImages.
  static constexpr std::size_t kSettlingImages = 150;
  static constexpr double kVeryClear = 2.0;
  static constexpr double kMinLowPoints = 20.0;  ///< of an image; fewer do not show the shape of feet
  /// Ratio of costs that are alike, so that noise does not turn the person in each image.
  static constexpr double kAlike = 1.01;
  static constexpr double kLikelyAwayAtFirst = 0.88;  ///< ratio, of fewer than kMinImages
  /// Walking alone does not decide, as people also walk backwards: the largest factor, and m from which it
  /// counts and at which it is reached.
  static constexpr double kMaxOfWalking = 1.22, kWalks = 0.3, kWalksFar = 0.8;
  static constexpr double kLongestStep = 0.1;  ///< s, between images of one walk

  /// The image at `t` (s), which may also precede the last one.
  void add(double t, const FacingEvidence& camera, const FacingEvidence& away);
  /// Facing away over facing the camera, of all images so far; NaN without images.
  double ratio() const;
  /// Whether facing away is the likelier direction; `away`: assumed so far, and kept if both are alike. Few
  /// images must show it clearly, as most people face the camera.
  bool isLikelyAway(bool away) const {
    if (images_ < kMinImages) return ratio() < kLikelyAwayAtFirst;
    return ratio() * (away ? 1.0 / kAlike : kAlike) < 1.0;
  }
  bool complete() const { return images_ >= kMaxImages; }
  /// Whether a decision is final: later movements may refute what the first images seem to show, unless these
  /// are beyond kVeryClear.
  bool settles() const {
    return images_ >= kSettlingImages || (images_ >= kMinImages && clearness() > kVeryClear);
  }
  /// If there are images enough, sets the ratio of `facing`, and whether the person kneels or is cut. The
  /// direction is decided if facing.decided() then.
  void judge(Facing& facing) const;

 private:
  double clearness() const { return std::max(ratio(), 1.0 / ratio()); }
  double feetFactor() const;
  double walkingFactor() const;

  /// Sums over the images.
  struct Sums {
    double cost{0.0}, low_cost{0.0}, empty_cost{0.0};
    double low_points{0.0};
    double square_distance{0.0};  ///< m^2
    double walked{0.0};           ///< m, forward
    void add(const FacingEvidence& evidence, bool feet_count);
  };
  std::size_t images_{0};
  std::size_t images_of_feet_{0};    ///< those in which the feet of both bodies are compared
  std::size_t images_on_knees_{0};   ///< those in which any of the bodies kneels
  std::size_t images_of_little_{0};  ///< those that show neither head nor feet of any of the bodies
  Sums camera_, away_;
  double last_t_{kNaN};                ///< s
  Vector3d last_p_{Vector3d::Zero()};  ///< m, middle of both pelves
};

}  // namespace abstand::tracking
