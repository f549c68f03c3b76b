// Differences of a robot's reaction from that of its scene file, as values.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/control/reaction_description.hpp"

namespace abstand::control {

/// Names are those of scene files. What is not named is as in the scene.
struct ReactionChange {
  std::map<std::string, bool> laws;                     ///< "repulsion": active or not
  std::map<std::string, config::JointNumbers> numbers;  ///< "repulsion.force", SI; one, or one for each joint
  std::map<std::string, safety::StopResponse> responses;  ///< by safety::reasonKey(): "lost_person"

  bool operator==(const ReactionChange&) const = default;
  bool empty() const { return laws.empty() && numbers.empty() && responses.empty(); }
};

/// The scene's reaction with a change of a robot with `dof` joints; a law that is switched on and that the
/// scene does not have starts with its default numbers. Throws UsageError for unknown names and for numbers
/// outside of their rules.
ReactionDescription changedReaction(const ReactionDescription& scene, const ReactionChange& change, int dof);

/// A number of a law, or one for each joint.
struct LawNumber {
  std::string key;             ///< "repulsion.force"
  config::JointNumbers value;  ///< with the change
  config::JointNumbers scene;  ///< without it
  config::NumberRule rule;
  bool each_joint{false};  ///< may be a list with a number for each joint
};

/// Response of the stop machine to a reason.
struct StopChoice {
  safety::StopReason reason{safety::StopReason::kUser};
  safety::StopResponse value{safety::StopResponse::kNone};  ///< with the change
  safety::StopResponse scene{safety::StopResponse::kNone};  ///< without it
};

struct LawState {
  std::string name;  ///< "repulsion"; also "hold" and "stop", which are always active
  bool on{true}, scene_on{true};
  bool switchable{false};  ///< false: always on
  /// It decides how the robot is driven, or what it holds: when it is switched, the loop begins anew.
  bool restarts{false};
  std::vector<LawNumber> numbers;
  std::vector<StopChoice> responses;  ///< of "stop": every reason
};

/// All laws with all their numbers, in the order of scene files, also of laws that are off. The change is not
/// checked.
std::vector<LawState> lawStates(const ReactionDescription& scene, const ReactionChange& change);

}  // namespace abstand::control
