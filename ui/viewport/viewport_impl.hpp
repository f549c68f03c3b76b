// Inside of the 3D view. VTK: .cpp files only.
#pragma once

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QTimer>

#include "ui/viewport/arrows.hpp"
#include "ui/viewport/camera.hpp"
#include "ui/viewport/object_actors.hpp"
#include "ui/viewport/overlay.hpp"
#include "ui/viewport/room.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

struct Viewport::Impl {
  Impl(Viewport& owner, Selection& selection);
  ~Impl();

  /// Takes over the last snapshot and asks for a frame when something looks different.
  void refresh();
  /// Soon, and not more often than this kind of OpenGL can.
  void askForFrame();
  void drawFrame();
  void resize();
  void setTheme();
  /// Labels, lines and legend for the camera as it is; before every frame.
  void fillOverlay();

  Viewport& owner;
  Selection& selection;
  ViewOptions options;
  const view::SceneOutline* outline{nullptr};
  view::SceneSnapshot snapshot;

  QVTKOpenGLNativeWidget* gl{nullptr};  // null without OpenGL
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  // Three layers, each drawn over the one before: floor and shadows, bodies, arrows (which bodies must not
  // hide).
  vtkNew<vtkRenderer> back, renderer, front;
  Room room;
  ObjectActors objects;
  Arrows arrows;
  Camera camera;
  Overlay* overlay;

  QTimer frame_timer;
  QElapsedTimer since_frame;
  int min_interval_ms{16};
  long frames{0};
  QPoint press, last_mouse;

 private:
  void addClosest();
  void addContactLabels();
  void addLegend();

  std::vector<int> order_;  // of the pairs by distance, kept from frame to frame
};

}  // namespace abstand::ui
