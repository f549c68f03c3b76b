// What faults of cameras mean for a track.
#pragma once

#include <span>

#include "tracking/tracker/camera_fault.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {

/// Adds to the reach of each joint doubtAt(), and what it moves in the time by which a camera is late; states
/// the faults in the shares of the cameras.
void widenByFaults(std::span<const CameraFault> faults, ClipTrack& track);

}  // namespace abstand::tracking
