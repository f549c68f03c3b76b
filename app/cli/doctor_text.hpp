// What the tracker doctor says, for people and for scripts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tracking/doctor/doctor.hpp"

namespace abstand::cli {

nlohmann::ordered_json doctorJson(const DoctorReport& report);
std::string doctorText(const DoctorReport& report);

}  // namespace abstand::cli
