// Picture of a depth image with the fitted body.
#pragma once

#include "tracking/depth/formats/colour_png.hpp"
#include "tracking/tracker/body_tracker.hpp"

namespace abstand::tracking {

/// Draws a depth image in grey, nearer is brighter, from column `left` of the picture on; pixels without a
/// measurement are nearly black.
void drawDepth(const DepthImage& image, int left, ColourImage& picture);

/// Draws the rig's shapes over a depth image, where they are at most 10 cm behind the measured depth: left
/// side of the body orange, right side blue, trunk and head green. `X_WS`: segments in the world of the
/// camera's pose.
void drawBody(const DepthImage& image, const DepthCamera& camera, const BodyRig& rig,
              const RigPlacement& X_WS, int left, ColourImage& picture);

/// The depth image of drawDepth(); beside it the same with drawBody(). A body that was not found is not
/// drawn.
ColourImage pictureOf(const DepthImage& image, const DepthCamera& camera, const BodyRig& rig,
                      const TrackedBody& body);

}  // namespace abstand::tracking
