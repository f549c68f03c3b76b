// The stature of a tracked person: measured, given, or known only as an interval.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// The vertical extent of a person in one image.
struct VerticalExtent {
  double height{0.0};  ///< m, highest to lowest pixel (to the floor where the lowest is close to it)
  double top{0.0};     ///< m, z of the highest pixel in the camera's world
  bool whole{false};   ///< seen down to the floor, and cut by neither the top nor the bottom of the image
};

/// The outermost half a per cent of the pixels is left out. Height 0 without pixels. The floor is z = 0 of
/// `camera`'s world.
VerticalExtent verticalExtent(const DepthImage& image, const DepthCamera& camera,
                              std::span<const std::uint8_t> is_person);

/// What is known of a person's stature, m.
struct Stature {
  enum class Source : std::uint8_t { kGiven, kMeasured, kInterval };
  Source source{Source::kInterval};
  double used{0.0};  ///< the fitted body was made for it; 0: no body was fitted
  std::array<double, 2> interval{kShortest, kTallest};   ///< kInterval: it lies between these
  std::string reason{"too few images show the person"};  ///< kInterval: why it was not measured

  bool known() const { return source != Source::kInterval; }
  /// Standard deviation if every value of the interval is equally likely; 0 where the stature is known.
  double deviation() const;

  /// Statures that are possible at all, and those of a person of whom it is believed that they stood upright:
  /// 1.45 m is below the first percentile of adult women (ANSUR II), 2.05 m above the 99th of men.
  static constexpr double kShortest = 1.3, kTallest = 2.1;
  static constexpr double kShortestUpright = 1.45, kTallestUpright = 2.05;
  /// Used where the images say nothing.
  static constexpr double kUsual = 1.70;

  static Stature given(double height);
};

/// The stature that the first images of a person show; their medians count. It is measured where more than
/// half of the images show the whole person and the result is that of an upright adult; else it is an
/// interval, with the extent that was seen as lower end. May allocate.
Stature measureStature(std::span<const VerticalExtent> images);

}  // namespace abstand::tracking
