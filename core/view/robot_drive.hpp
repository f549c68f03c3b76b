// Which laws decide how a robot is driven, and which of them it permits.
#pragma once

#include <string>

#include "core/control/reaction_description.hpp"

namespace abstand::view {

/// Empty: permitted.
struct RobotDrive {
  std::string no_torques;  ///< why the robot cannot be driven by torques, so that it needs an `admittance`
  std::string no_proxy;    ///< why it cannot have a `proxy`
};

/// Why a reaction does not fit the robot; empty: it fits.
inline std::string driveProblem(const RobotDrive& drive, const control::ReactionDescription& reaction) {
  if (!reaction.admittance && !drive.no_torques.empty()) return drive.no_torques;
  return reaction.proxy ? drive.no_proxy : std::string();
}

/// The two reactions drive their robot in different ways: its loop has to begin anew.
inline bool drivenOtherwise(const control::ReactionDescription& a, const control::ReactionDescription& b) {
  return a.admittance.has_value() != b.admittance.has_value() || a.proxy.has_value() != b.proxy.has_value();
}

}  // namespace abstand::view
