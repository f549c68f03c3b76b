// Common output of commands that track people.
#pragma once

#include <nlohmann/json.hpp>

#include "app/cli/command_line.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::cli {

/// Parses --facing: "camera", "away" or "auto"; nullopt for the last. Throws UsageError.
std::optional<bool> awayOf(const std::string& facing);

/// {facing, facing_decided, facing_ratio} of a person.
void addFacing(nlohmann::ordered_json& person, const tracking::Facing& facing);

/// {height_estimate, height_interval, height_source, height_used}: the estimate is null if only an interval
/// is known, the interval is null otherwise; `used` is that of the fitted body.
void addStature(nlohmann::ordered_json& person, const tracking::Stature& stature);

/// All people of a track, sorted by the number of images found.
nlohmann::ordered_json peopleJson(const tracking::ClipTrack& track);

/// {file, camera_reason, images, images_with_people, moments_without, images_repeated, moved_at, hung_at,
/// disagrees_since, disagreement, late_since, late} of one camera; `name`: its file, or that of a live
/// camera.
nlohmann::ordered_json cameraJson(const std::string& name, const tracking::DepthFacts& facts,
                                  const tracking::CameraShare& share);
/// Images, people and absent images of camera `number` (from 1), without a line break.
std::string cameraText(std::size_t number, const std::string& name, const tracking::CameraShare& share,
                       std::size_t times);

/// Reports a track that was interrupted after `images` images, before the person was found. Returns
/// kInterrupted.
int endBeforeFound(const CommandLine& line, std::size_t images);

}  // namespace abstand::cli
