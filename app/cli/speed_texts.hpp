// What `tune` says of speeds.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

/// "both", "separation" or "contact".
std::string_view ruleName(tune::SpeedRule rule);

/// `speeds`, `speed_rule` and `cycle_time`; `proof`, `profile` and `trade` where they were asked for.
void addSpeeds(const tune::TuneAnswer& answer, nlohmann::ordered_json& document);
std::string speedsText(const tune::TuneAnswer& answer);
/// One line on what the replays of a speed profile showed.
std::string proofLine(const tune::TuneAnswer& answer);

}  // namespace abstand::cli
