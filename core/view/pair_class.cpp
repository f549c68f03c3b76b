#include "core/view/pair_class.hpp"

#include <algorithm>

#include "core/view/snapshot.hpp"

namespace abstand::view {

namespace {

/// A body of no person and no mechanism is in this group.
constexpr const char* kThings = "objects";

BodySide sideOf(const SceneOutline::ObjectInfo& object) {
  if (object.human) return BodySide::kPerson;
  return object.group == kThings ? BodySide::kThing : BodySide::kRobot;
}

}  // namespace

PairClass pairClassOf(BodySide a, BodySide b) {
  const auto [first, second] = std::minmax(a, b);
  if (first == BodySide::kPerson && second == BodySide::kRobot) return PairClass::kPersonRobot;
  if (first == BodySide::kPerson && second == BodySide::kThing) return PairClass::kPersonThing;
  if (first == BodySide::kRobot && second == BodySide::kRobot) return PairClass::kRobotRobot;
  if (first == BodySide::kRobot && second == BodySide::kThing) return PairClass::kRobotThing;
  return PairClass::kOther;
}

PairClass pairClassOf(const SceneOutline& outline, std::pair<int, int> pair) {
  return pairClassOf(sideOf(outline.objects[static_cast<std::size_t>(pair.first)]),
                     sideOf(outline.objects[static_cast<std::size_t>(pair.second)]));
}

}  // namespace abstand::view
