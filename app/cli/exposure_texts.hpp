// What `exposure` answers.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

nlohmann::ordered_json exposureJson(const tune::TuneAnswer& answer);
std::string exposureText(const tune::TuneAnswer& answer);
/// A row for the whole body, each part, link, pair and stretch of the program.
void writeExposureCsv(const tune::ExposureTable& table, std::ostream& out);

}  // namespace abstand::cli
