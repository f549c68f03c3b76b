// Hands the document's margins, pairs and posed robots to a session.
#pragma once

#include <QStringList>
#include <map>
#include <optional>
#include <vector>

#include "ui/document/work.hpp"
#include "ui/model/session_port.hpp"

namespace abstand::ui {

/// Sends commands for what differs from the scene, and later for what changes. GUI thread only.
class SessionFollower {
 public:
  /// Sends all of `work`. `first`: the session's first snapshot, which shows what the scene says. Null: no
  /// session; nothing is sent.
  void attach(SessionPort* port, const view::SceneSnapshot& first, const Work& work);
  /// Sends what differs.
  void follow(const Work& before, const Work& after);

  /// m, of an object as `work` has it.
  double margin(const Work& work, int object) const;
  /// Of all objects.
  std::vector<double> margins(const Work& work) const;
  /// m, of all pairs of a class; nullopt: the sums of the objects' margins.
  static std::optional<double> classMargin(const Work& work, view::PairClass pair_class);
  /// m, of all objects: margins whose sums are those of the pairs of people and robots, also where this class
  /// has its own. The recording is judged with them.
  std::vector<double> reviewMargins(const Work& work) const;
  /// rad or m: joints of a robot (index of the outline) that `work` poses by hand; empty: it does not, or not
  /// with this number of joints.
  QVector<double> posed(const Work& work, int robot) const;
  /// The reaction of a robot (index of SceneOutline::reacting) as `work` has it; that of the scene, and why,
  /// if the change does not fit the robot.
  control::ReactionDescription reaction(const Work& work, int robot, QString* problem = nullptr) const;
  /// Names of objects, groups, robots and people in `work` that the scene does not have, sorted.
  QStringList unknownNames(const Work& work) const;

 private:
  int group(const Work& work, int pair) const;
  void followPosed(const Work& before, const Work& after);
  void followClasses(const Work& before, const Work& after);
  void followThings(const Work& before, const Work& after);
  void followReactions(const Work& before, const Work& after);
  view::PairGroupState state(const Work& work, int group) const;

  SessionPort* port_{nullptr};
  std::vector<QString> names_;   // by object
  std::vector<double> margins_;  // m, by object, of the scene
  std::vector<int> pair_group_;  // by pair, of the scene; -1: none
  std::vector<QString> groups_;
  std::map<QString, int> group_of_name_;
};

}  // namespace abstand::ui
