// Edits of the document that name bodies, pairs and robots of the scene.
#pragma once

#include <QObject>

#include "ui/panel_set.hpp"

namespace abstand::view {
struct SceneOutline;
struct SceneSnapshot;
}  // namespace abstand::view

namespace abstand::ui {

class Document;
class SceneTreeModel;
class SessionFollower;

/// What the user does in panels becomes edits of the document, each with a name. GUI thread only.
class SceneEdits : public QObject {
  Q_OBJECT

 public:
  struct Sources {
    Document& document;
    const SessionFollower& follower;
    const SceneTreeModel& tree;
    const view::SceneSnapshot& moment;
  };

  /// All outlive it.
  SceneEdits(const Sources& sources, const PanelSet& panels, QObject* parent);

  /// Of the scene that is open; it must live until the next call.
  /// `fixed`: another program decides which pairs are checked.
  void open(const view::SceneOutline& outline, bool fixed) {
    outline_ = &outline;
    fixed_ = fixed;
  }

 Q_SIGNALS:
  /// For the status bar.
  void said(const QString& text);

 private:
  void connectGroups(const PanelSet& panels);
  void connectJoints(const PanelSet& panels);
  void connectReactions(const PanelSet& panels);
  void connectPlaces(const PanelSet& panels);
  void showObjects(const std::vector<int>& objects, bool visible);
  void movePair(int pair, const QString& group);
  void checkPair(int a, int b, bool checked);
  void poseJoint(int robot, int joint, double value);
  QString nameOf(int object) const;

  Sources my_;
  const view::SceneOutline* outline_{nullptr};
  bool fixed_{false};
};

}  // namespace abstand::ui
