// Output of `exposure`.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::cli {

nlohmann::ordered_json exposureJson(const tune::TuneAnswer& answer);
std::string exposureText(const tune::TuneAnswer& answer);
/// One row for the whole body, and for each part, link, pair and program segment.
void writeExposureCsv(const tune::ExposureTable& table, std::ostream& out);

}  // namespace abstand::cli
