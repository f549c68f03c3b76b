// Common output of `run` and `check`: reservations and smallest distances.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/run/run_scene.hpp"

namespace abstand::cli {

/// [{kind, text, t0, t1, share, fails}]; null if a number does not apply; with `recording` if there are
/// several.
nlohmann::ordered_json reservationsJson(const std::vector<run::Reservation>& reservations);

/// One line each: "reservation (KIND): TEXT".
std::string reservationsText(const std::vector<run::Reservation>& reservations);

/// {a, b, t, value}, or null.
nlohmann::ordered_json extremeJson(const std::optional<run::RunSummary::Extreme>& extreme);

using ByClass = std::array<std::optional<run::RunSummary::Extreme>, run::kPairClasses.size()>;

/// {person_robot, person_thing, robot_robot, robot_thing}, each {a, b, t, value}, or null without such a
/// pair.
nlohmann::ordered_json byClassJson(const ByClass& least);

/// One line for each class with pairs, people first.
std::string closestText(const ByClass& least);

}  // namespace abstand::cli
