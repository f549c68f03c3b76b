// Half a minute of work, with everything that people do in between.
#pragma once

#include "tests/tracking/tracker/posed_scenes.hpp"

namespace abstand::testing {

/// Somebody in front of a chair who stands, reaches ahead, bends to the floor, kneels, works on the knees,
/// raises both arms, squats, sits down, and stands up again: 32 s, seen from eight sides, `session_from_45`.
std::vector<PosedScene> workSessions();

}  // namespace abstand::testing
