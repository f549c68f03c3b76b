// Classes of pairs: whom a distance is about.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "core/math/transform.hpp"

namespace abstand::view {

struct SceneOutline;

/// In the order in which they matter to people. A thing is a body of no person and no robot; kOther: two
/// people or two things.
enum class PairClass : std::uint8_t { kPersonRobot, kPersonThing, kRobotRobot, kRobotThing, kOther };
inline constexpr std::size_t kPairClasses = 5;
/// Names in files, in this order, of the classes that may have a margin of their own: all but kOther.
inline constexpr std::array<const char*, kPairClasses - 1> kPairClassNames{"person_robot", "person_thing",
                                                                           "robot_robot", "robot_thing"};

enum class BodySide : std::uint8_t { kPerson, kRobot, kThing };
PairClass pairClassOf(BodySide a, BodySide b);
/// `pair`: an entry of SceneOutline::pairs.
PairClass pairClassOf(const SceneOutline& outline, std::pair<int, int> pair);

/// m, of each PairClass; infinity: no distance is known.
using ClassDistances = std::array<double, kPairClasses>;
inline constexpr ClassDistances kNoDistances{kInfinity, kInfinity, kInfinity, kInfinity, kInfinity};

}  // namespace abstand::view
