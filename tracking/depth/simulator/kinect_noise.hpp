// Noise model of a Kinect of 2010.
#pragma once

#include <cstdint>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Structured-light camera with a projector beside it. Values of Khoshelham, Elberink, Sensors 2012
/// (baseline, disparities in eighths of a pixel, i.e. steps of 2.9 mm z^2 [z in m, f = 580]) and of Nguyen,
/// Izadi, Lovell, 3DIMPVT 2012 (lateral sigma 0.8 pixels; axial sigma 1.2 mm + 1.9 mm (z - 0.4)^2).
struct KinectNoise {
  double baseline{0.075};              ///< m; distance of the projector along the camera's x
  double disparity_step{0.125};        ///< pixels
  double across{0.8};                  ///< pixels, lateral standard deviation
  double along{0.0012};                ///< m, axial standard deviation of the depth at 0.4 m ...
  double along_growth{0.0019};         ///< ... and its coefficient of (z - 0.4)^2, 1/m
  double nearest{0.5}, farthest{8.0};  ///< m; no measurement outside of this range
  double grazing{0.14};  ///< cosine of the angle to the surface normal; flatter surfaces are not measured
};

/// The noise of the same camera in images of another size: `across` and `disparity_step` are in pixels of 640
/// columns; a smaller image, as from the driver, has fewer.
KinectNoise kinectNoiseIn(const DepthCamera& camera);

/// Adds projector shadows, ragged edges, noise, disparity steps, and missing pixels where the surface is too
/// flat, too near or too far. Deterministic for a seed and frame.
DepthImage seenByKinect(const DepthImage& ideal, const DepthCamera& camera, const KinectNoise& noise,
                        std::uint64_t seed, std::uint64_t frame);

}  // namespace abstand::tracking
