// Reach of the joints of somebody of whom two bodies are tracked, which face opposite ways.
#pragma once

#include "tracking/tracker/tracked_body.hpp"

namespace abstand::tracking {

/// If `body` was found: adds to the reach of each of its joints the place and reach in `other`, which faces
/// the other way in the same image, or in the flipped body if `other` was not found, or has turned to face as
/// `body` does. No allocation, no throw.
void encloseOtherFacing(const TrackedBody& other, TrackedBody& body);

}  // namespace abstand::tracking
