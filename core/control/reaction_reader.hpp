// The `reaction` of a mechanism in a scene file.
#pragma once

#include <string>

#include "core/config/yaml_reader.hpp"
#include "core/control/reaction_description.hpp"

namespace abstand::control {

/// Reads the `reaction` of a mechanism:
///
/// reaction:
///   torque: {gain: 1, limit: 40, cut: together}    # limit: a number or one a joint; cut: each, together
///   repulsion: {range: 0.1, force: 50, damping: 0.7, mass: 5, stop_distance: 0, stop_share: 1}
///   proxy: {stiffness: 1000, rotation_stiffness: 10, force: 50, torque: 5, gap: 0.0005, step: 0.01}
///   admittance: {inertia: 1, damping: 10, stiffness: 20, velocity: 1, offset: 0.5}     # numbers or lists
///   speed: {reaction_time: 0.1, stopping_time: 0.3, ..., release: 2, least: 0.02}
///   hold: {frequency: 6, damping: 1}
///   stop: {distance: 0.02, input_age: 0.1, person_age: 0.2, joint_speed: 2, resume_after: 1,
///          standstill: 0.001, slow_to: 0.25, on: {lost_person: protective, user: emergency}}
///                                                   # none, slow, protective, emergency
///
/// A law that is not named is off; `hold` and `stop` always apply. Throws ParseError at the position of an
/// error; for unknown keys with the nearest known one. Whether lists fit the robot's joints is checked by the
/// constructor of Reaction.
ReactionDescription readReaction(const config::YamlNode& node, const std::string& file);

/// The description as YAML that reads back as equal, each line after `indent`. Infinite numbers, which mean
/// no limit, are omitted.
std::string describeReaction(const ReactionDescription& reaction, const std::string& indent = "");

}  // namespace abstand::control
