// Where people and robots stand that come from different files.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/session/session.hpp"
#include "ui/document/placement.hpp"

namespace abstand::studio {

/// m, from the foremost point of the robots at the first frame to the nearest point of the person in any
/// frame.
inline constexpr double kPersonGap = 0.5;

struct DefaultPlacement {
  std::string person, robot;  ///< who is placed: a person, or another robot; and at which robot
  ui::Placement placement;    ///< of the person's recording, or of the robot's base
};

/// The first person with a recording stands in front of the base of the first robot, on its x axis, faces it
/// in the first frame, stands as low as the robots, and never comes nearer than kPersonGap, as far as 400
/// frames of the recording tell; rounded to centimetres and degrees. Moves the session. nullopt: no robot
/// with links, or no recording.
std::optional<DefaultPlacement> defaultPlacement(session::Session& session);
/// m, between the boxes of two robots.
inline constexpr double kRobotGap = 0.2;
/// The robots after the first stand beside those before, along y, at the first frame; rounded up to
/// centimetres. Moves the session to that frame and its robots to these places, apart from those in `placed`.
std::vector<DefaultPlacement> placeRobotsBeside(session::Session& session,
                                                const std::set<std::string>& placed);
/// Alike but for rounding.
bool isSame(const ui::Placement& a, const ui::Placement& b);

}  // namespace abstand::studio
