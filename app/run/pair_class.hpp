// Who meets whom in a pair: people come first.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/session/session.hpp"

namespace abstand::run {

enum class Side : std::uint8_t { kPerson, kRobot, kThing };

/// Whose a body of this group is.
Side sideOf(const scene_file::SceneDescription& scene, const std::string& group);

/// kOther: two people, two things, or parts of one person.
enum class PairClass : std::uint8_t { kPersonRobot, kPersonThing, kRobotRobot, kRobotThing, kOther };

/// Those that are reported apart, in this order.
inline constexpr std::array kPairClasses{PairClass::kPersonRobot, PairClass::kPersonThing,
                                         PairClass::kRobotRobot, PairClass::kRobotThing};

/// "person_robot", as in JSON.
const char* pairClassKey(PairClass pair_class);
/// "person to robot", for people.
const char* pairClassText(PairClass pair_class);

/// Of each pair of the session's scene, in its order.
std::vector<PairClass> pairClasses(const session::Session& session);

}  // namespace abstand::run
