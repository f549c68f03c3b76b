// What the inspector is about: one body, a pair, a robot, a person, or several bodies.
#pragma once

#include <QString>
#include <vector>

#include "core/view/snapshot.hpp"

namespace abstand::ui {

enum class SubjectKind { kNone, kBody, kPair, kRobot, kPerson, kSeveral };

struct InspectedSubject {
  SubjectKind kind{SubjectKind::kNone};
  std::vector<int> objects;  ///< of the outline, in order
  int pair{-1};              ///< of kPair
  int robot{-1};             ///< index into SceneOutline::robots; of a robot and of its links
  int person{-1};            ///< index into SceneOutline::people; of a person and of body parts
  bool operator==(const InspectedSubject&) const = default;
};

/// @param objects  what is chosen: one body, or all of a robot or of a person
/// @param pair     the pair when it was chosen as a pair, else -1
InspectedSubject inspectedSubject(const view::SceneOutline& outline, const std::vector<int>& objects,
                                  int pair);

/// The name to show: "left_arm", "arm/link1 – operator/head".
QString subjectTitle(const view::SceneOutline& outline, const InspectedSubject& subject);

/// A robot of the outline is posed by hand at this moment.
bool isByHand(const view::SceneSnapshot& snapshot, int robot);
/// Index into SceneOutline::robots, -1 for none.
int robotOf(const view::SceneOutline& outline, const std::string& name);

}  // namespace abstand::ui
