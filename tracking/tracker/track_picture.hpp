// A depth image with the body that was fitted to it, to look at.
#pragma once

#include "tracking/depth/formats/colour_png.hpp"
#include "tracking/tracker/body_tracker.hpp"

namespace abstand::tracking {

/// The depth image in grey, nearer is brighter, and beside it the same with the rig's shapes drawn where they
/// are nearer than 10 cm behind what was measured: the left side of the body orange, the right one blue,
/// trunk and head green. Nothing is drawn of a body that was not found.
ColourImage pictureOf(const DepthImage& image, const DepthCamera& camera, const BodyRig& rig,
                      const TrackedBody& body);

}  // namespace abstand::tracking
