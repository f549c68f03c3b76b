// Output of `tune` about margins of links and pairs, sets of margins, closest approaches and bands.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

/// The counts of an outcome: stops, stopped_share, false_stops, ...
nlohmann::ordered_json outcomeJson(const margin::MarginOutcome& outcome);
nlohmann::ordered_json strategiesJson(const tune::TuneAnswer& answer);
nlohmann::ordered_json groupNeedsJson(const tune::TuneAnswer& answer,
                                      const std::vector<tune::GroupNeed>& needs);
/// null for an empty name.
nlohmann::ordered_json toolJson(const std::string& tool);
nlohmann::ordered_json closestJson(const tune::TuneAnswer& answer);
nlohmann::ordered_json bandsJson(const tune::TuneAnswer& answer);
std::string closestText(const tune::TuneAnswer& answer);
std::string bandsText(const tune::TuneAnswer& answer);
std::string strategiesText(const tune::TuneAnswer& answer);
std::string groupNeedsText(const tune::TuneAnswer& answer);

}  // namespace abstand::cli
