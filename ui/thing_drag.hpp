// Objects of the room are moved and turned by handles in the 3D view.
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "core/view/snapshot.hpp"
#include "ui/document/placement.hpp"

namespace abstand::ui {

class Document;
class Selection;
class SessionPort;
class Viewport;

/// A selected object of the room has handles. Pulling one is an edit of the document, one undo step from
/// taking hold to letting go. GUI thread only.
class ThingDrag : public QObject {
  Q_OBJECT

 public:
  static constexpr double kStep = 0.01;  ///< m, of a key

  struct Sources {
    Document& document;
    const Selection& selection;
    Viewport& viewport;
    const view::SceneSnapshot& moment;
  };

  /// All outlive it.
  ThingDrag(const Sources& sources, QObject* parent);

  /// Null: none.
  void open(const SessionPort* session);
  /// Moves a thing by kStep along the axis of the world that is nearest to a direction (world): a step of its
  /// own.
  void step(int object, const Vector3d& direction_W);

 private:
  struct Held {
    QString name;
    Placement from;
    Vector3d centre_W;  ///< m, about which it turns
  };
  void showHandles();
  void grab(int object, const Vector3d& centre_W);
  void pull(const Vector3d& shift, double turn);
  void release();

  Sources my_;
  const SessionPort* session_{nullptr};
  std::optional<Held> held_;
};

}  // namespace abstand::ui
