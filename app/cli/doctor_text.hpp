// What the tracker doctor says, for people and for scripts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tracking/doctor/doctor.hpp"
#include "tracking/doctor/prediction_trial.hpp"

namespace abstand::cli {

nlohmann::ordered_json doctorJson(const DoctorReport& report);
std::string doctorText(const DoctorReport& report);

nlohmann::ordered_json predictionJson(const std::vector<PredictionTrial>& trials, const MotionBounds& bounds);
std::string predictionText(const std::vector<PredictionTrial>& trials, const MotionBounds& bounds);

}  // namespace abstand::cli
