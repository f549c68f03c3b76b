// Where a person stands whose recording and robot come from different files.
#pragma once

#include <optional>
#include <string>

#include "app/session/session.hpp"
#include "ui/document/placement.hpp"

namespace abstand::studio {

/// m, from the foremost point of the robots at the first frame to the nearest point of the person in any
/// frame.
inline constexpr double kPersonGap = 0.5;

struct DefaultPlacement {
  std::string person, robot;
  ui::Placement placement;  ///< of the person's recording
};

/// The first person with a recording stands in front of the base of the first robot, on its x axis, faces it
/// in the first frame, stands as low as the robots, and never comes nearer than kPersonGap, as far as 400
/// frames of the recording tell; rounded to centimetres and degrees. Moves the session. nullopt: no robot
/// with links, or no recording.
std::optional<DefaultPlacement> defaultPlacement(session::Session& session);
/// Alike but for rounding.
bool isSame(const ui::Placement& a, const ui::Placement& b);

}  // namespace abstand::studio
