// The objects of a scene by group.
#include "ui/model/groups.hpp"

#include <algorithm>
#include <array>

#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

GroupKind kindOf(const view::SceneOutline::ObjectInfo& info) {
  if (info.human) return GroupKind::kHuman;
  return isThing(info) ? GroupKind::kObjects : GroupKind::kMechanism;
}

}  // namespace

bool isThing(const view::SceneOutline::ObjectInfo& info) { return !info.human && info.group == "objects"; }

std::vector<Group> groupsOf(const view::SceneOutline& outline) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < outline.objects.size(); ++i) {
    const auto& info = outline.objects[i];
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.name == info.group; });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{info.group, kindOf(info), 0, {}});
    group->objects.push_back(static_cast<int>(i));
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.kind < b.kind; });
  std::array<int, 3> count{};
  for (Group& group : groups) group.index_of_kind = count[static_cast<std::size_t>(group.kind)]++;
  return groups;
}

QString groupTitle(const Group& group) {
  return group.kind == GroupKind::kObjects ? tr("objects") : QString::fromStdString(group.name);
}

std::string shortName(const view::SceneOutline::ObjectInfo& info) {
  const std::string prefix = info.group + "/";
  return info.name.size() > prefix.size() && info.name.starts_with(prefix) ? info.name.substr(prefix.size())
                                                                           : info.name;
}

std::string clearName(const view::SceneOutline& outline, std::size_t object) {
  const std::string name = shortName(outline.objects[object]);
  const auto same = std::count_if(outline.objects.begin(), outline.objects.end(),
                                  [&](const auto& other) { return shortName(other) == name; });
  return same > 1 ? outline.objects[object].name : name;
}

}  // namespace abstand::ui
