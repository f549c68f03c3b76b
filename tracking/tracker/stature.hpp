// Stature of a tracked person: measured, given, or an interval.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "humanmodel/human_model.hpp"
#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// The vertical extent of a person in one image, or in those of several cameras together.
struct VerticalExtent {
  double height{0.0};    ///< m, highest to lowest pixel (to the floor if the lowest is close to it)
  double top{0.0};       ///< m, z of the highest pixel in the camera's world
  bool whole{false};     ///< seen down to the floor, and top and bottom not cut by the image of every camera
  bool headless{false};  ///< cut by the top of every image: the head is higher than `top`
  double head{kNaN};  ///< m, z of the vertex of a person whose hands are higher (headBelowHands()); else NaN
};

/// Vertical extent without the outermost 0.5 % of the pixels, of all images together. Height 0 without
/// pixels. The floor is z = 0 of the cameras' world.
VerticalExtent verticalExtent(std::span<const PersonImage> images);

/// Knowledge of a person's stature, m.
struct Stature {
  enum class Source : std::uint8_t { kGiven, kMeasured, kInterval };
  Source source{Source::kInterval};
  double used{0.0};                                      ///< stature of the fitted body; 0: none was fitted
  std::array<double, 2> interval{kShortest, kTallest};   ///< kInterval: bounds
  std::string reason{"too few images show the person"};  ///< kInterval: reason why it was not measured
  double seen{kNaN};  ///< height of the person in the images, seen from head to feet; NaN: not so

  /// kInterval: narrows the bounds to the statures (m) that the lengths of the parts indicate, widened by
  /// kProportions; `used` stays within.
  void narrow(const std::array<double, 2>& indicated);

  bool known() const { return source != Source::kInterval; }
  /// RMS difference (m) between `used` and a uniform distribution over the interval; 0 if the stature is
  /// known.
  double deviation() const;

  /// Limits of possible statures, and of those of upright adults: 1.45 m is below the first percentile of
  /// adult women (ANSUR II), 2.05 m above the 99th of men.
  static constexpr double kShortest = 1.0, kTallest = 2.1;
  static constexpr double kShortestUpright = 1.45, kTallestUpright = 2.05;
  /// m; a higher head is not that of a person on a chair: the longest trunk with head, 1.05 (ANSUR II: 99 %
  /// of men are below 1.01), on a seat of 0.53.
  static constexpr double kTallestSeated = 1.58;
  /// m; statures that the lengths of parts give have this error: twice the standard deviation of a stature
  /// that is estimated from the sitting height (0.52 of it, standard deviation of the ratio 0.013; ANSUR II).
  static constexpr double kProportions = 0.09;
  /// Share of the stature that is above the floor of a person on a chair: 0.52 above the seat (ANSUR II),
  /// 0.26 below.
  static constexpr double kSeatedShare = 0.78;
  /// Likewise of a person on the knees with the trunk upright (kneeling height of men, 50th percentile: 1.295
  /// m of 1.74 m; Pheasant and Haslegrave, Bodyspace, 3rd edition).
  static constexpr double kKneelingShare = 0.74;
  /// m, of the vertex: by which it is lower in a stooped posture, assumed for the first fit.
  static constexpr double kLowered = 0.2;
  /// m, of hands above the vertex: half of what the longest arms allow.
  static constexpr double kAboveHead = 0.2;
  /// Default if the images show nothing.
  static constexpr double kUsual = 1.70;

  /// Factor on the cost of the images for a body of this stature (m): 1 for the mean adult, more for others.
  static double unusual(double height);

  static Stature given(double height);
  /// Of a child, or another person who stands and is `seen` (m) high, less than kShortestUpright.
  static Stature ofChild(double seen);
  /// Of a person who sits and is `seen` (m) high.
  static Stature ofSeated(double seen);
  /// Of a person who kneels with the trunk upright and is `seen` (m) high.
  static Stature ofKneeling(double seen);
  /// Of a person who stoops, crouches or sits on something high, and is `seen` (m) high.
  static Stature ofLowered(double seen);
  /// Of a person who stands with raised arms, up to `seen` (m).
  static Stature ofRaisedArms(double seen);
};

/// The mean body of a stature (m).
inline humanmodel::HumanOptions usualBody(double height) {
  humanmodel::HumanOptions body;
  body.height = height;
  return body;
}

/// Stature from the medians of a person's first images. Measured if more than half of the images show the
/// whole person and the result is that of an upright adult; otherwise an interval, with the observed extent
/// as lower end. May allocate.
Stature measureStature(std::span<const VerticalExtent> images);

}  // namespace abstand::tracking
