// Inside of the 3D view. VTK: .cpp files only.
#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QTimer>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "ui/model/body_state.hpp"
#include "ui/viewport/arrows.hpp"
#include "ui/viewport/camera.hpp"
#include "ui/viewport/canvas.hpp"
#include "ui/viewport/cloud_actor.hpp"
#include "ui/viewport/handles.hpp"
#include "ui/viewport/inside_actors.hpp"
#include "ui/viewport/object_actors.hpp"
#include "ui/viewport/overlay.hpp"
#include "ui/viewport/room.hpp"
#include "ui/viewport/sensor_actor.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

struct Viewport::Impl {
  Impl(Viewport& owner, Selection& selection);
  ~Impl();

  /// Takes over the last snapshot; true when something looks different.
  bool update();
  /// The same, and asks for a frame.
  void refresh();
  /// Decides whether what follows is one of many.
  void noteChange();
  /// Soon, and not more often than this kind of OpenGL can.
  void askForFrame();
  /// In full quality, unless the picture is one of many: then floor and background stay from the one before
  /// where the camera does, and edges are not smoothed.
  void drawFrame(bool one_of_many);
  void setQuality(bool one_of_many);
  void fitDepth();
  void resize();
  void setTheme();
  /// m, world; nullopt: no body has handles.
  std::optional<Vector3d> handleCentre() const;
  /// Labels, lines and legend for the camera as it is; before every frame.
  void fillOverlay();

  Viewport& owner;
  Selection& selection;
  ViewOptions options;
  const view::SceneOutline* outline{nullptr};
  view::SceneSnapshot snapshot;

  Canvas* gl{nullptr};  // null without OpenGL
  // Three layers, each drawn over the one before: floor and shadows, bodies, arrows (which bodies must not
  // hide).
  vtkNew<vtkRenderer> back, renderer, front;
  Room room;
  ObjectActors objects;
  Arrows arrows;
  InsideActors inside;
  struct {
    CloudActor cloud;
    SensorActor sensor;
  } depth_views;  // what depth cameras see and would see
  Camera camera;
  Overlay* overlay;

  QTimer frame_timer, rest_timer;  // until the next picture may be drawn; until the view counts as at rest
  QElapsedTimer since_frame;       // since the last picture was begun
  int min_interval_ms{16};
  bool cheap_when_moving{false};  // the processor draws
  struct {
    CameraView backdrop;  ///< of the canvas's backdrop
    CameraView last;      ///< of the last picture
  } cameras;
  struct {
    long frames{0};                 ///< number of pictures so far
    long step{-1};                  ///< SceneSnapshot::step
    std::vector<BodyState> bodies;  ///< states of the objects
  } shown;
  struct {
    QPoint pressed, last;
    std::optional<Vector3d> held;  ///< m, world: the point that the user pulls or pokes
    bool pokes{false};
    Handles handles;
    int handled{-1};                  ///< the body that has them
    std::function<QString(int)> tip;  ///< of a body under the pointer; empty: none
    /// m, world: a line from a point to where it shall be
    std::optional<std::pair<Vector3d, Vector3d>> pull;
  } mouse;

 private:
  void addClosest();
  BodyState stateOf(int object) const;
  void addBodyLabels();
  void addRobotLabels();
  void addPoke();
  void addHandles();
  void addLegend();

  /// Which lines are drawn.
  struct {
    std::vector<int> order;    ///< of the pairs by key, kept from frame to frame
    std::vector<double> keys;  ///< of the pairs
  } closest_;
};

}  // namespace abstand::ui
