// Output of `tune` about the standards: tables in use, protective distances and predicted contacts.
#pragma once

#include <nlohmann/json.hpp>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

/// Adds the editions, the tables, and the numbers of the tables that the answer follows from.
void addStandards(const tune::TuneAnswer& answer, nlohmann::ordered_json& j);
/// For each part: time with a violated protective distance over all recordings, and the worst moment.
nlohmann::ordered_json separationJson(const tune::TuneAnswer& answer);
/// For each part: time in which a contact would have exceeded a limit, and the hardest contact.
nlohmann::ordered_json contactsJson(const tune::TuneAnswer& answer);

}  // namespace abstand::cli
