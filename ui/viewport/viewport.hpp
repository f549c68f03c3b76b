// The 3D view.
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <memory>

#include "core/view/moment_poses.hpp"
#include "core/view/snapshot.hpp"
#include "ui/document/camera_view.hpp"
#include "ui/document/view_options.hpp"
#include "ui/model/body_inside.hpp"
#include "ui/model/coverage_report.hpp"
#include "ui/model/depth_cloud.hpp"
#include "ui/viewport/prepared_meshes.hpp"

namespace abstand::ui {

class Overlay;
class Selection;

/// Draws the newest snapshot when something in it has changed. Left button: orbit, or pull the handle under
/// the pointer; click: choose; middle or right: pan; wheel: zoom; Ctrl and left: a body is pulled; Ctrl,
/// Shift and left: it is poked. Without OpenGL it says so and the rest of the window works. GUI thread only.
class Viewport : public QWidget {
  Q_OBJECT

 public:
  explicit Viewport(Selection& selection, QWidget* parent = nullptr);
  ~Viewport() override;

  /// Builds all actors and looks at the scene. The outline must live until the next open() or close().
  /// `meshes`: those of the outline; null: they are prepared now.
  void open(const view::SceneOutline& outline, const view::SceneSnapshot& first,
            const std::shared_ptr<const PreparedMeshes>& meshes = nullptr);
  void close();
  /// Draws at once what looks different.
  void refresh(const view::SceneSnapshot& snapshot);
  /// SceneSnapshot::step of what is drawn.
  long shownStep() const;
  /// ms from the start of a picture to that of the next that this kind of OpenGL can keep up with.
  int interval() const;

  /// What the tool tip says of a body; asked for while the pointer rests over it.
  void setTipSource(std::function<QString(int object)> tip);
  /// The tip at a point of the picture, logical pixels from the upper left corner; empty where nothing is.
  QString tipAt(const QPoint& at) const;
  const ViewOptions& options() const;
  void setOptions(const ViewOptions& options);
  void setObjectVisible(int object, bool visible);
  /// What is drawn of the inside of the selected bodies.
  void setInsideSource(InsideOf source);
  void setInsideView(InsideView view, int level);
  InsideView insideView() const;
  int insideLevel() const;
  /// Bodies of which it is drawn.
  std::size_t insideShown() const;
  /// Measured points in place of those before; none: an empty list.
  void showCloud(const std::vector<CloudPoint>& points, CloudColours colours);
  /// Number of points that are drawn.
  std::size_t cloudShown() const;
  /// The field of view of a planned depth camera, until hideSensor(). `X_W`: its optical frame in the world.
  void showSensor(const Transform& X_W, const SensorKind& kind);
  void hideSensor();
  /// What is drawn of it, as SensorActor::corners(); empty: nothing.
  std::vector<Vector3d> sensorCorners() const;
  void look(CameraPreset preset);
  void fit();
  void fitSelection();
  /// As a drag by so many logical pixels.
  void orbit(double dx, double dy);
  void pan(double dx, double dy);
  /// Multiplies the distance of the camera from its focus.
  void zoom(double factor);
  /// Where the camera stands; without OpenGL where it would.
  CameraView cameraView() const;
  void setCameraView(const CameraView& view);
  /// The key that the labels of robots tell that wait for a reset.
  void setResetKey(const QString& key);
  /// In the middle of the view while no scene is open.
  void setMessage(const QString& text);

  /// The bodies at another moment, without labels and marks, from where the camera stands; at most
  /// `width` pixels wide. What is shown does not change. Null without OpenGL, or for poses of another scene.
  QImage preview(const view::MomentPoses& moment, int width);
  /// The picture with labels, at the screen's resolution.
  QImage picture();
  /// What is written over the picture.
  const Overlay& overlay() const;
  /// Where a point of the scene is in the picture, logical pixels from the upper left corner.
  QPointF project(const Vector3d& p_W) const;
  /// World direction of one on the screen (x right, y down, z towards the eye).
  Vector3d fromScreen(const Vector3d& direction) const;
  /// A line from a point of the scene to where it shall be, until hidePull().
  void showPull(const Vector3d& p_W, const Vector3d& target_W);
  void hidePull();
  /// The body that has handles; -1: none.
  void setHandles(int object);
  /// Number of frames drawn so far.
  long framesDrawn() const;

 Q_SIGNALS:
  /// The user has moved the camera.
  void cameraMoved();
  /// The user has taken hold of a body at a point of its surface (world, m), pulls this point to another one
  /// in the same depth, and lets go.
  void bodyGrabbed(int object, const abstand::Vector3d& p_W);
  void bodyPulled(const abstand::Vector3d& p_W);
  void bodyReleased();
  /// The same for a force on the body.
  void bodyPoked(int object, const abstand::Vector3d& p_W);
  void pokeMoved(const abstand::Vector3d& target_W);
  void pokeEnded();
  /// The user has taken hold of a handle of a body, whose centre (m, world) is told, pulls it by a shift (m,
  /// world) or a turn (rad, about the vertical through that centre), and lets go.
  void handleGrabbed(int object, const abstand::Vector3d& centre_W);
  void handlePulled(const abstand::Vector3d& shift, double turn);
  void handleReleased();
  /// The user scrubs in the view: the pointer has moved by this share of its width, to the right.
  void scrubbed(double share);
  /// A picture is drawn; it took so long (s) on this thread.
  void drawn(double seconds);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void grabBody(const QPoint& at, bool poke);
  bool grabHandle(const QPoint& at);
  bool pullHandle(const QPoint& at);
  bool releaseHandle();
  void moveMouse(const QMouseEvent& mouse);
  void releaseMouse(const QMouseEvent& mouse);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::ui
