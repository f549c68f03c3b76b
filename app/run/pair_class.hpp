// Classes of pairs: person, robot or thing.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/session/session.hpp"

namespace abstand::run {

enum class Side : std::uint8_t { kPerson, kRobot, kThing };

/// Side of the bodies of a group.
Side sideOf(const scene_file::SceneDescription& scene, const std::string& group);

/// kOther: two people, two things, or two parts of one person.
enum class PairClass : std::uint8_t { kPersonRobot, kPersonThing, kRobotRobot, kRobotThing, kOther };

/// Classes reported separately, in this order.
inline constexpr std::array kPairClasses{PairClass::kPersonRobot, PairClass::kPersonThing,
                                         PairClass::kRobotRobot, PairClass::kRobotThing};

/// Key in JSON, "person_robot".
const char* pairClassKey(PairClass pair_class);
/// Text, "person to robot".
const char* pairClassText(PairClass pair_class);

/// Class of each pair of the session's scene, in order.
std::vector<PairClass> pairClasses(const session::Session& session);

}  // namespace abstand::run
