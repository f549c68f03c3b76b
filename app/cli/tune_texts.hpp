// Output of `tune`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

nlohmann::ordered_json approachJson(const tune::RankedApproach& ranked);
nlohmann::ordered_json tuneJson(const tune::TuneAnswer& answer);
std::string tuneText(const tune::TuneAnswer& answer);

}  // namespace abstand::cli
