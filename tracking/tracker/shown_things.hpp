// Whether the images of a live camera show the things that are said to be in front of it.
#pragma once

#include "tracking/tracker/known_objects.hpp"

namespace abstand::tracking {

/// Compares rendered images of known things, as a robot, with those of one camera. Things elsewhere, because
/// of a wrong camera pose or of joint values of another robot, must not be removed: people behind the place
/// where they are said to be would be, too. Initially they count as shown. One thread. Does not allocate.
class ShownThings {
 public:
  /// `known`: the things, rendered for the image of `camera` at `t` (s, increasing); null: not known at
  /// present, which compares nothing. The image and it have the same size. Returns whether the things are
  /// shown. `at_rest`: those whose displacement is measured, as what moves is known at several places; null:
  /// none.
  bool see(double t, const DepthImage& image, const DepthImage* known, const DepthImage* at_rest,
           const DepthCamera& camera);

  /// Whether the image at `t` is compared: only then at_rest is used.
  bool isDue(double t) const { return t >= next_; }
  bool areShown() const { return shown_; }
  /// Share of the compared pixels without a nearer surface that have the depth of the things; NaN: nothing
  /// was compared. Earlier images count less.
  double share() const;
  /// How far from their place; things that are displaced, but near, are shown.
  const DisplacedThings& displaced() const { return displaced_; }

  static constexpr double kEvery = 0.2;       ///< s between two compared images
  static constexpr double kForget = 0.9;      ///< weight of the images before, at each one
  static constexpr double kPixels = 2000.0;   ///< to decide
  static constexpr double kElsewhere = 0.35;  ///< smaller shares are those of things that are not there
  static constexpr double kThere = 0.6;  ///< larger ones, of things that are there again, unless displaced

 private:
  double there_{0.0}, all_{0.0};  ///< pixels
  DisplacedThings displaced_;
  double next_{-kInfinity};  ///< s
  bool shown_{true};
};

}  // namespace abstand::tracking
