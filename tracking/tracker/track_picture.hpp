// Picture of a depth image with the fitted body.
#pragma once

#include "tracking/depth/formats/colour_png.hpp"
#include "tracking/tracker/body_tracker.hpp"

namespace abstand::tracking {

/// The depth image in grey, nearer is brighter; beside it the same with the rig's shapes, drawn where they
/// are at most 10 cm behind the measured depth: left side of the body orange, right side blue, trunk and head
/// green. A body that was not found is not drawn.
ColourImage pictureOf(const DepthImage& image, const DepthCamera& camera, const BodyRig& rig,
                      const TrackedBody& body);

}  // namespace abstand::tracking
