#include "ui/model/pair_class.hpp"
#include "ui/style/tr.hpp"

#include <algorithm>

namespace abstand::ui {

namespace {

/// A body of no person and no mechanism is in this group.
constexpr const char* kThings = "objects";

enum Side { kPerson, kRobot, kThing };

Side sideOf(const view::SceneOutline::ObjectInfo& object) {
  if (object.human) return kPerson;
  return object.group == kThings ? kThing : kRobot;
}

}  // namespace

PairClass pairClassOf(const view::SceneOutline& outline, std::pair<int, int> pair) {
  const Side a = sideOf(outline.objects[static_cast<std::size_t>(pair.first)]);
  const Side b = sideOf(outline.objects[static_cast<std::size_t>(pair.second)]);
  const auto [first, second] = std::minmax(a, b);
  if (first == kPerson && second == kRobot) return PairClass::kPersonRobot;
  if (first == kPerson && second == kThing) return PairClass::kPersonThing;
  if (first == kRobot && second == kRobot) return PairClass::kRobotRobot;
  if (first == kRobot && second == kThing) return PairClass::kRobotThing;
  return PairClass::kOther;
}

QString pairClassName(PairClass pair_class) {
  switch (pair_class) {
    case PairClass::kPersonRobot:
      return tr("Person – robot");
    case PairClass::kPersonThing:
      return tr("Person – thing");
    case PairClass::kRobotRobot:
      return tr("Robot – robot");
    case PairClass::kRobotThing:
      return tr("Robot – thing");
    case PairClass::kOther:
      break;
  }
  return tr("Other pairs");
}

QString pairClassInSentence(PairClass pair_class) {
  switch (pair_class) {
    case PairClass::kPersonRobot:
      return tr("person – robot");
    case PairClass::kPersonThing:
      return tr("person – thing");
    case PairClass::kRobotRobot:
      return tr("robot – robot");
    case PairClass::kRobotThing:
      return tr("robot – thing");
    case PairClass::kOther:
      break;
  }
  return tr("other pairs");
}

}  // namespace abstand::ui
