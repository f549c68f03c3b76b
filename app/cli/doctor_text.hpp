// Output of the recording doctor as text and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tracking/doctor/doctor.hpp"
#include "tracking/doctor/prediction_trial.hpp"

namespace abstand::cli {

nlohmann::ordered_json doctorJson(const tracking::DoctorReport& report);
std::string doctorText(const tracking::DoctorReport& report);

nlohmann::ordered_json predictionJson(const std::vector<tracking::PredictionTrial>& trials,
                                      const safety::MotionBounds& bounds);
std::string predictionText(const std::vector<tracking::PredictionTrial>& trials,
                           const safety::MotionBounds& bounds);

}  // namespace abstand::cli
