// A recording of a person from whatever shows one: skeletons, markers, or depth.
#pragma once

#include <filesystem>

#include "tracking/recording/recording.hpp"
#include "tracking/tracker/clip_tracker.hpp"
#include "tracking/tracker/track_monitor.hpp"

namespace abstand::tracking {

/// The person of a track as a recording; its report says what was understood of the depth, where the world
/// comes from, and the size of the body. Throws UsageError where there is no such person. `person` counts
/// from 0, the one who was found in most images.
Recording recordingOf(const ClipTrack& track, const DepthFacts& facts, std::size_t person);

/// Where the person looked at first, and why that is thought, in a sentence's rest.
std::string facingReason(const Facing& facing);

/// The stature in words, "1.76 m, measured" or an interval with its reason.
std::string statureReason(const Stature& stature);

/// What weakens the track of a person, a sentence each: an undecided facing, a stature that is not known.
std::vector<std::string> trackWarnings(const ClipPerson& person);

/// Whether a path is a depth recording: a folder, or a file of images, clouds or arrays of depth.
bool isDepthRecording(const std::filesystem::path& path);

/// openRecording(), and for a depth recording its first person, tracked. `height` (m): of the body; else it
/// is measured. With `known`, which cuts out what is no person, the recording has to say how its camera
/// stands. Throws ParseError, UsageError, and Interrupted when an interrupt comes while it tracks, or the
/// monitor ends it.
Recording openAnyRecording(const std::filesystem::path& path, const RecordingOptions& options,
                           std::optional<double> height, const KnownThings& known = {},
                           const TrackMonitor& monitor = {});

}  // namespace abstand::tracking
