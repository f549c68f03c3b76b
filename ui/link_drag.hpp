// Links of robots are pulled in the 3D view, or moved by keys.
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "core/view/snapshot.hpp"

namespace abstand::ui {

class Actions;
class Document;
class Selection;
class SessionFollower;
class SessionPort;
class Viewport;

/// Poses a robot by hand so that a point of a link follows the pointer, within the joint limits: an edit of
/// the document, one undo step from taking hold to letting go. GUI thread only.
class LinkDrag : public QObject {
  Q_OBJECT

 public:
  static constexpr double kStep = 0.01;  ///< m, of a key

  struct Sources {
    Document& document;
    const SessionFollower& follower;
    Selection& selection;
    Viewport& viewport;
    const view::SceneSnapshot& moment;
  };

  /// All outlive it.
  LinkDrag(const Sources& sources, const Actions& actions, QObject* parent);

  /// Null: none.
  void open(const SessionPort* session);

 Q_SIGNALS:
  /// A thing is selected, and the user wants it to move in this direction (world).
  void thingWanted(int object, const abstand::Vector3d& direction_W);
  /// For the status bar.
  void said(const QString& text);

 private:
  struct Held {
    int object, robot;
    Vector3d p_B;                ///< m, the point in the body's frame
    std::vector<double> joints;  ///< rad, m: of the robot, as last found
  };
  void connectKeys(const Actions& actions);
  std::optional<Held> hold(int object, const Vector3d& p_W);
  void grab(int object, const Vector3d& p_W);
  void pull(const Vector3d& p_W);
  void release();
  void move(const Vector3d& on_screen);
  void pose(Held& held, const Vector3d& p_W, const QString& merge_key);

  Sources my_;
  const SessionPort* session_{nullptr};
  std::optional<Held> held_;
};

}  // namespace abstand::ui
