// Classes of pairs: whom a distance is about.
#pragma once

#include <QString>

#include "core/view/snapshot.hpp"

namespace abstand::ui {

/// In the order in which they matter to people. A thing is a body of no person and no robot.
enum class PairClass { kPersonRobot, kPersonThing, kRobotRobot, kRobotThing, kOther };
inline constexpr int kPairClasses = 5;

/// `pair`: an entry of SceneOutline::pairs.
PairClass pairClassOf(const view::SceneOutline& outline, std::pair<int, int> pair);
/// "Person – robot".
QString pairClassName(PairClass pair_class);
/// "person – robot", within a sentence.
QString pairClassInSentence(PairClass pair_class);

}  // namespace abstand::ui
