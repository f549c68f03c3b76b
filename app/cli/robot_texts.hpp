// Output about reacting robots as text and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/loop/loop_report.hpp"
#include "app/run/joint_limits.hpp"

namespace abstand::cli {

/// `robots` of the JSON document: one object each.
nlohmann::ordered_json robotsJson(const std::vector<loop::ReactionReport>& robots);
/// A few lines each.
std::string robotsText(const std::vector<loop::ReactionReport>& robots);

/// `joint_limits` of the JSON document: one object each.
nlohmann::ordered_json jointLimitsJson(const std::vector<run::JointLimitReport>& reports);
/// One line each.
std::string jointLimitsText(const std::vector<run::JointLimitReport>& reports);

}  // namespace abstand::cli
