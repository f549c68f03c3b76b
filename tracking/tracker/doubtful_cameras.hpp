// What faults of cameras mean for a track.
#pragma once

#include <span>
#include <string>

#include "tracking/tracker/camera_fault.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {

/// States the faults, which begin with the track at `begin` (s) or later, in the shares of the cameras.
void stateFaults(std::span<const CameraFault> faults, double begin, std::span<CameraShare> shares);

/// Adds to the reach of each joint doubtAt(), and what it moves in the time by which a camera is late; states
/// the faults in the shares of the cameras.
void widenByFaults(std::span<const CameraFault> faults, ClipTrack& track);

/// The rest of a sentence on a camera with a fault of kind kApart, and kLate.
std::string apartReason(const CameraShare& share);
std::string lateReason(const CameraShare& share);

}  // namespace abstand::tracking
