// Words for the classes of pairs.
#include "ui/model/pair_class.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

QString pairClassKey(PairClass pair_class) {
  const auto i = static_cast<std::size_t>(pair_class);
  return i < view::kPairClassNames.size() ? QString::fromLatin1(view::kPairClassNames[i]) : QString();
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
