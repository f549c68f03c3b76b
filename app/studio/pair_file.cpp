// Pairs of a robot's links that are not checked, as SRDF.
#include "app/studio/pair_file.hpp"

#include <map>

namespace abstand::studio {

namespace {

/// "link1" of "arm/link1".
std::string linkOf(const std::string& name, const std::string& robot) {
  return name.starts_with(robot + "/") ? name.substr(robot.size() + 1) : name;
}

QPair<QString, QString> namesOf(const view::SceneOutline& outline, int a, int b) {
  return {QString::fromStdString(outline.objects[static_cast<std::size_t>(a)].name),
          QString::fromStdString(outline.objects[static_cast<std::size_t>(b)].name)};
}

}  // namespace

robot_file::Srdf uncheckedPairs(const view::SceneOutline& outline, const ui::Work& work,
                                const std::string& robot) {
  robot_file::Srdf srdf;
  srdf.robot = robot;
  const auto add = [&](int a, int b, const char* reason) {
    const auto& one = outline.objects[static_cast<std::size_t>(a)];
    const auto& other = outline.objects[static_cast<std::size_t>(b)];
    if (one.group == robot && other.group == robot)
      srdf.disabled.push_back({linkOf(one.name, robot), linkOf(other.name, robot), reason, {}});
  };
  for (const view::UncheckedPair& pair : outline.unchecked)
    if (!work.added.contains(namesOf(outline, pair.a, pair.b)))
      add(pair.a, pair.b, pair.reason == view::UncheckedReason::kAdjacent ? "Adjacent" : "Default");
  for (const auto& [a, b] : outline.pairs) {
    const auto moved = work.moved.find(namesOf(outline, a, b));
    if (moved != work.moved.end() && moved->isEmpty()) add(a, b, "User");
  }
  return srdf;
}

std::size_t disablePairs(const robot_file::Srdf& srdf, const view::SceneOutline& outline,
                         const std::string& robot, ui::Work& work) {
  std::map<std::string, int> object_of;
  for (std::size_t i = 0; i < outline.objects.size(); ++i)
    if (outline.objects[i].group == robot)
      object_of[linkOf(outline.objects[i].name, robot)] = static_cast<int>(i);
  std::map<std::pair<int, int>, bool> is_pair;
  for (const auto& pair : outline.pairs) is_pair[pair] = true;
  std::size_t count = 0;
  for (const robot_file::DisabledPair& pair : srdf.disabled) {
    const auto a = object_of.find(pair.link1), b = object_of.find(pair.link2);
    if (a == object_of.end() || b == object_of.end()) continue;
    const auto [first, second] = std::minmax(a->second, b->second);
    if (!is_pair.contains({first, second})) continue;
    work.moved[namesOf(outline, first, second)] = QString();
    ++count;
  }
  return count;
}

}  // namespace abstand::studio
