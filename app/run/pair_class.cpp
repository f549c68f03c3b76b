#include "app/run/pair_class.hpp"

#include <algorithm>

namespace abstand::run {
namespace {

PairClass classOf(Side a, Side b) {
  if (b < a) std::swap(a, b);
  if (a == Side::kPerson && b == Side::kRobot) return PairClass::kPersonRobot;
  if (a == Side::kPerson && b == Side::kThing) return PairClass::kPersonThing;
  if (a == Side::kRobot && b == Side::kRobot) return PairClass::kRobotRobot;
  return a == Side::kRobot ? PairClass::kRobotThing : PairClass::kOther;
}

}  // namespace

Side sideOf(const scene_file::SceneDescription& scene, const std::string& group) {
  const auto named = [&](const auto& list) {
    return std::any_of(list.begin(), list.end(), [&](const auto& g) { return g.name == group; });
  };
  if (named(scene.humans)) return Side::kPerson;
  return named(scene.mechanisms) ? Side::kRobot : Side::kThing;
}

const char* pairClassKey(PairClass pair_class) {
  switch (pair_class) {
    case PairClass::kPersonRobot:
      return "person_robot";
    case PairClass::kPersonThing:
      return "person_thing";
    case PairClass::kRobotRobot:
      return "robot_robot";
    case PairClass::kRobotThing:
      return "robot_thing";
    case PairClass::kOther:
      break;
  }
  return "other";
}

const char* pairClassText(PairClass pair_class) {
  switch (pair_class) {
    case PairClass::kPersonRobot:
      return "person to robot";
    case PairClass::kPersonThing:
      return "person to thing";
    case PairClass::kRobotRobot:
      return "robot to robot";
    case PairClass::kRobotThing:
      return "robot to thing";
    case PairClass::kOther:
      break;
  }
  return "others";
}

std::vector<PairClass> pairClasses(const session::Session& session) {
  const scene::Scene& scene = session.scene();
  std::vector<Side> sides;
  for (const scene::Object& o : scene.objects()) sides.push_back(sideOf(session.description(), o.spec.group));
  std::vector<PairClass> classes;
  for (const scene::Pair& p : scene.pairs())
    classes.push_back(classOf(sides[p.a.index()], sides[p.b.index()]));
  return classes;
}

}  // namespace abstand::run
