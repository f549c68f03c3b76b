// The objects of a scene by group: mechanisms, people, things in the room.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/view/snapshot.hpp"

namespace abstand::ui {

enum class GroupKind { kMechanism, kHuman, kObjects };

struct Group {
  std::string name;
  GroupKind kind{GroupKind::kObjects};
  int index_of_kind{0};      ///< 0 for the first mechanism, 1 for the second ...
  std::vector<int> objects;  ///< indices of the outline, in order
};

/// In the order of the first member: mechanisms first, then people, then objects.
std::vector<Group> groupsOf(const view::SceneOutline& outline);

/// An object of the room: of no person and no robot.
bool isThing(const view::SceneOutline::ObjectInfo& info);

/// As the window shows it: that of the things in the room has no name of its own.
QString groupTitle(const Group& group);

/// "hand_left" of "operator/hand_left" in the group "operator"; the whole name otherwise.
std::string shortName(const view::SceneOutline::ObjectInfo& info);
/// The short name, or the whole one where several objects have the same short name.
std::string clearName(const view::SceneOutline& outline, std::size_t object);

}  // namespace abstand::ui
