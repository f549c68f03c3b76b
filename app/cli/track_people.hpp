// What the commands that track people say of them.
#pragma once

#include <nlohmann/json.hpp>

#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::cli {

/// "camera", "away" or "auto", as of --facing; nothing for the last. Throws UsageError.
std::optional<bool> awayOf(const std::string& facing);

/// {facing, facing_ratio} of a person.
void addFacing(nlohmann::ordered_json& person, const Facing& facing);

/// All people of a track, those found in most images first.
nlohmann::ordered_json peopleJson(const ClipTrack& track);

}  // namespace abstand::cli
