// What a Kinect of 2010 makes of an ideal depth image.
#pragma once

#include <cstdint>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// A camera that sees the pattern of a projector beside it. Numbers of Khoshelham, Elberink, Sensors 2012
/// (the baseline, disparities in eighths of a pixel, so steps of 2.9 mm z^2 [z in m, f = 580]) and of Nguyen,
/// Izadi, Lovell, 3DIMPVT 2012 (sigma across 0.8 pixels; along 1.2 mm + 1.9 mm (z - 0.4)^2).
struct KinectNoise {
  double baseline{0.075};              ///< m; the projector stands so far along the camera's x
  double disparity_step{0.125};        ///< pixels
  double across{0.8};                  ///< pixels, standard deviation of where a depth is seen
  double along{0.0012};                ///< m, standard deviation of the depth at 0.4 m ...
  double along_growth{0.0019};         ///< ... and what it grows by (z - 0.4)^2, 1/m
  double nearest{0.5}, farthest{8.0};  ///< m; beyond, nothing is measured
  double grazing{0.14};  ///< cosine of the angle to the surface's normal; flatter ones are not seen
};

/// The same camera's noise in images of another size: `across` and `disparity_step` are measured in pixels of
/// 640 columns, of which a smaller image, as the driver makes it, has fewer.
KinectNoise kinectNoiseIn(const DepthCamera& camera);

/// Shadows where the projector does not reach, edges that fray, noise, steps, and pixels missing where the
/// surface is seen too flat, too near or too far. The same numbers for the same seed and frame.
DepthImage seenByKinect(const DepthImage& ideal, const DepthCamera& camera, const KinectNoise& noise,
                        std::uint64_t seed, std::uint64_t frame);

}  // namespace abstand::tracking
