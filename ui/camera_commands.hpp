// The commands that move the camera, its history, and a camera that follows.
#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/document/camera_view.hpp"

namespace abstand::ui {

class Actions;
class Selection;
class Viewport;

/// Views of the camera are no edits of the document: they have a history of their own. Movements that follow
/// each other within half a second are one. GUI thread only.
class CameraCommands : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMaxViews = 100;
  static constexpr int kOneMovementMs = 500;

  /// All outlive it.
  CameraCommands(const Actions& actions, Viewport& viewport, const Selection& selection, QObject* parent);

  /// Before a moment is drawn: moves the camera with the selection where it follows.
  void follow(const view::SceneSnapshot& snapshot);
  /// Another scene: views of the old one are forgotten.
  void forget();

 private:
  void noteMovement();
  void go(std::vector<CameraView>& from, std::vector<CameraView>& to);
  void showHistory();

  const Actions& actions_;
  Viewport& viewport_;
  const Selection& selection_;
  std::vector<CameraView> before_, after_;
  CameraView last_;  ///< where the camera stood when it last rested
  QTimer moving_;    ///< while movements belong together
  struct {
    std::vector<int> objects;
    Vector3d at{Vector3d::Zero()};  ///< m
    bool on{false};
  } followed_;
};

}  // namespace abstand::ui
