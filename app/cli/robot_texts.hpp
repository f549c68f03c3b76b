// What robots that reacted went through, for people and for scripts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/loop/loop_report.hpp"
#include "app/run/joint_limits.hpp"

namespace abstand::cli {

/// `robots` of the JSON document: an object each.
nlohmann::ordered_json robotsJson(const std::vector<loop::ReactionReport>& robots);
/// A few lines each.
std::string robotsText(const std::vector<loop::ReactionReport>& robots);

/// `joint_limits` of the JSON document: an object each.
nlohmann::ordered_json jointLimitsJson(const std::vector<run::JointLimitReport>& reports);
/// A line each.
std::string jointLimitsText(const std::vector<run::JointLimitReport>& reports);

}  // namespace abstand::cli
