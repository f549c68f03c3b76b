// Recording of a person from skeletons, markers or depth images.
#pragma once

#include <filesystem>

#include "tracking/recording/recording.hpp"
#include "tracking/tracker/known_objects.hpp"
#include "tracking/tracker/track_monitor.hpp"

namespace abstand::tracking {

/// Converts a person of a track to a recording; its report states the interpretation of the depth, the source
/// of the world frame, and the size of the body. Throws UsageError if there is no such person. `person`
/// counts from 0, sorted by the number of images found.
Recording recordingOf(const ClipTrack& track, const DepthFacts& facts, std::size_t person);

/// Initial facing direction with its reason, as the rest of a sentence.
std::string facingReason(const Facing& facing);

/// The stature in words: "1.76 m, measured", or an interval with its reason.
std::string statureReason(const Stature& stature);

/// Reservations about the track of a person, one sentence each: undecided facing, unknown stature.
std::vector<std::string> trackWarnings(const ClipPerson& person);

/// That a track has other people than the one that is used, and in how many images; empty: it has none.
std::string othersWarning(const ClipTrack& track, std::size_t person);

/// Things in the person's hands, one sentence for each hand.
std::vector<std::string> heldNotes(const ClipPerson& person);

/// Cameras that were moved while they recorded or repeat their images, one sentence each.
std::vector<std::string> cameraWarnings(const ClipTrack& track);

/// True for a depth recording: a folder, or a file of depth images, clouds or arrays.
bool isDepthRecording(const std::filesystem::path& path);

/// openRecording(); for a depth recording its first person, tracked. `height` (m): stature of the body;
/// otherwise measured. A note of the report states whether known objects were removed from the images. If
/// they must be, the recording must state its camera pose. Throws ParseError, UsageError, and Interrupted on
/// an interrupt during tracking, or if the monitor ends it.
Recording openAnyRecording(const std::filesystem::path& path, const RecordingOptions& options,
                           std::optional<double> height, const KnownObjects& objects = {},
                           const TrackMonitor& monitor = {});

}  // namespace abstand::tracking
