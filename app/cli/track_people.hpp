// What the commands that track people say of them.
#pragma once

#include <nlohmann/json.hpp>

#include "app/cli/command_line.hpp"
#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::cli {

/// "camera", "away" or "auto", as of --facing; nothing for the last. Throws UsageError.
std::optional<bool> awayOf(const std::string& facing);

/// {facing, facing_decided, facing_ratio} of a person.
void addFacing(nlohmann::ordered_json& person, const tracking::Facing& facing);

/// {height_estimate, height_interval, height_source, height_used}: the estimate is null where the stature is
/// known as an interval only, the interval null where it is known; `used` is that of the fitted body.
void addStature(nlohmann::ordered_json& person, const tracking::Stature& stature);

/// All people of a track, those found in most images first.
nlohmann::ordered_json peopleJson(const tracking::ClipTrack& track);

/// The report of a track that was interrupted after `images` images, before the person was found. Gives
/// kInterrupted.
int endBeforeFound(const CommandLine& line, std::size_t images);

}  // namespace abstand::cli
