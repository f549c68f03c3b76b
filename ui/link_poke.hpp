// Links of robots that react are poked in the 3D view, or by a key.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>

#include "core/view/snapshot.hpp"

class QAction;

namespace abstand::ui {

class Document;
class Selection;
class SessionFollower;
class SessionPort;
class Viewport;

/// Pulls a point of a link to the pointer by a force that acts on the reaction of its robot. Not an edit: it
/// ends when the user lets go. Says why a robot cannot yield. GUI thread only.
class LinkPoke : public QObject {
  Q_OBJECT

 public:
  static constexpr int kRenewMs = 50;    ///< the session forgets a poke that is not renewed
  static constexpr int kPushMs = 500;    ///< of the key
  static constexpr double kPush = 0.15;  ///< m, of the key, away from the camera

  struct Sources {
    const Document& document;
    const SessionFollower& follower;
    Selection& selection;
    Viewport& viewport;
    const view::SceneSnapshot& moment;
  };

  /// All outlive it. `push`: pokes the selected link.
  LinkPoke(const Sources& sources, const QAction* push, QObject* parent);

  /// Null: none.
  void open(SessionPort* session);

 Q_SIGNALS:
  /// For the status bar.
  void said(const QString& text);

 private:
  struct Held {
    int object;
    Vector3d p_B, target_W;  ///< m: the point in the body's frame, and where it is pulled to
  };
  QString whyNot(int object, const Vector3d& p_W) const;
  QString whyRobotDoesNotYield(int robot) const;
  bool begin(int object, const Vector3d& p_W);
  void move(const Vector3d& target_W);
  void send();
  void end();
  void push();

  Sources my_;
  SessionPort* session_{nullptr};
  std::optional<Held> held_;
  QTimer renew_, push_end_;
};

}  // namespace abstand::ui
