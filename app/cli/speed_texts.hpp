// Output of `tune` about speeds.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

/// "both", "separation" or "contact".
std::string_view ruleName(tune::SpeedRule rule);

/// `speeds`, `speed_rule` and `cycle_time`; `proof`, `profile` and `trade` if requested.
void addSpeeds(const tune::TuneAnswer& answer, nlohmann::ordered_json& document);
std::string speedsText(const tune::TuneAnswer& answer);
/// One line about the replays of a speed profile.
std::string proofLine(const tune::TuneAnswer& answer);

}  // namespace abstand::cli
