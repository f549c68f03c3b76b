// The 3D view, drawn with VTK.
#include "ui/viewport/viewport.hpp"

#include <vtkBoundingBox.h>
#include <vtkMath.h>

#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/model/selection.hpp"
#include "ui/viewport/mesh_data.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/viewport/plain_pass.hpp"
#include "ui/viewport/viewport_impl.hpp"

namespace abstand::ui {

namespace {

constexpr int kSoftwareIntervalMs = 30;  // from the start of a picture to that of the next
constexpr int kHardwareIntervalMs = 16;
constexpr int kRestMs = 110;  // without a change, until a picture in full quality
constexpr int kHardwareSamples = 4;
constexpr int kClickSlack = 4;  // px that a click may wander
constexpr double kZoomPerNotch = 0.88;

}  // namespace

Viewport::Impl::Impl(Viewport& viewport, Selection& chosen)
    : owner{viewport},
      selection{chosen},
      room{back, renderer},
      objects{renderer, back},
      arrows{front},
      inside{front},
      depth_views{CloudActor(renderer), SensorActor(renderer)},
      camera{renderer},
      overlay{new Overlay(&viewport)} {
  auto* layout = new QVBoxLayout(&owner);
  layout->setContentsMargins(0, 0, 0, 0);
  const OpenGlInfo& info = openGlInfo();
  if (!info.available) {
    auto* sorry = new QLabel(
        Viewport::tr("No OpenGL 3.2 here: the 3D view stays empty, everything else works."), &owner);
    sorry->setAlignment(Qt::AlignCenter);
    layout->addWidget(sorry);
    overlay->hide();
    return;
  }
  min_interval_ms = info.software ? kSoftwareIntervalMs : kHardwareIntervalMs;
  gl = new Canvas(&owner);
  vtkGenericOpenGLRenderWindow* window = gl->window();
  gl->setFocusPolicy(Qt::NoFocus);
  gl->setAccessibleName(Viewport::tr("3D view"));
  gl->installEventFilter(&owner);
  layout->addWidget(gl);
  window->SetMultiSamples(info.software ? 0 : kHardwareSamples);
  window->SetNumberOfLayers(3);
  int layer = 0;
  drawPlainly(back);
  drawPlainly(renderer);
  window->SetAlphaBitPlanes(1);
  for (vtkRenderer* each : {back.Get(), renderer.Get(), front.Get()}) {
    each->SetLayer(layer++);
    each->SetActiveCamera(renderer->GetActiveCamera());
    window->AddRenderer(each);
  }
  cheap_when_moving = info.software;
  setQuality(false);
  overlay->raise();
  frame_timer.setSingleShot(true);
  QObject::connect(&frame_timer, &QTimer::timeout, &owner,
                   [this] { drawFrame(cheap_when_moving && rest_timer.isActive()); });
  rest_timer.setSingleShot(true);
  rest_timer.setInterval(kRestMs);
  QObject::connect(&rest_timer, &QTimer::timeout, &owner, [this] {
    if (gl->hasBackdrop() || !front->GetUseFXAA()) drawFrame(false);
  });
  since_frame.start();
}

Viewport::Impl::~Impl() = default;

bool Viewport::Impl::update() {
  if (!outline || !gl) return false;
  findBodyStates(*outline, snapshot, shown.bodies);
  bool changed = objects.refresh(snapshot, shown.bodies, selection, options);
  changed |= arrows.refresh(*outline, snapshot, options);
  changed |= inside.refresh(snapshot, selection.objects());
  return changed;
}

void Viewport::Impl::refresh() {
  if (update()) askForFrame();
}

void Viewport::Impl::noteChange() {
  // A change alone is drawn in full quality at once; when more follow, they are many.
  if (since_frame.elapsed() < kRestMs || snapshot.playing) rest_timer.start();
}

void Viewport::Impl::askForFrame() {
  if (!gl) return;
  noteChange();
  if (!frame_timer.isActive())
    frame_timer.start(std::max<int>(0, min_interval_ms - static_cast<int>(since_frame.elapsed())));
}

void Viewport::Impl::fitDepth() {
  // One camera for three layers: it must reach from the nearest to the farthest of all of them.
  vtkBoundingBox all;
  for (vtkRenderer* each : {back.Get(), renderer.Get(), front.Get()}) {
    double bounds[6];
    each->ComputeVisiblePropBounds(bounds);
    if (vtkMath::AreBoundsInitialized(bounds)) all.AddBounds(bounds);
  }
  double bounds[6];
  all.GetBounds(bounds);
  if (all.IsValid()) renderer->ResetCameraClippingRange(bounds);
}

void Viewport::Impl::setQuality(bool one_of_many) {
  // The last layer smooths the whole picture; cheaper than multisampling where the processor draws.
  front->SetUseFXAA(cheap_when_moving && !one_of_many);
  const CameraView now = camera.view();
  const bool still = now == cameras.last;
  cameras.last = now;
  if (!one_of_many || !still) {
    gl->dropBackdrop();
    room.setLeftOut(false);
    return;
  }
  if (!gl->hasBackdrop() || !(cameras.backdrop == now)) {
    room.setLeftOut(false);
    objects.shadows().setShown(false);
    renderer->DrawOff();
    front->DrawOff();
    back->SetUseFXAA(true);
    fitDepth();
    gl->keepBackdrop();
    back->SetUseFXAA(false);
    front->DrawOn();
    renderer->DrawOn();
    objects.shadows().setShown(true);
    cameras.backdrop = now;
  }
  room.setLeftOut(true);
}

void Viewport::Impl::drawFrame(bool one_of_many) {
  frame_timer.stop();
  since_frame.restart();
  setQuality(one_of_many);
  fitDepth();
  fillOverlay();
  gl->render();
  overlay->update();
  ++shown.frames;
  Q_EMIT owner.drawn(1e-9 * static_cast<double>(since_frame.nsecsElapsed()));
}

void Viewport::Impl::resize() {
  overlay->setGeometry(owner.rect());
  camera.setViewSize(gl ? gl->size() : owner.size());
  askForFrame();
}

void Viewport::Impl::setTheme() {
  const Theme theme = themeOf(owner.palette());
  room.setTheme(theme);
  if (gl) gl->dropBackdrop();
  objects.setTheme(theme);
  refresh();
  askForFrame();
}

Viewport::Viewport(Selection& selection, QWidget* parent)
    : QWidget(parent), impl_{std::make_unique<Impl>(*this, selection)} {
  setMinimumSize(240, 180);
  impl_->setTheme();
  connect(&selection, &Selection::changed, this, [this] {
    impl_->refresh();
    impl_->askForFrame();
  });
}

Viewport::~Viewport() {
  if (impl_->gl) impl_->gl->removeEventFilter(this);
}

void Viewport::open(const view::SceneOutline& outline, const view::SceneSnapshot& first,
                    const std::shared_ptr<const PreparedMeshes>& meshes) {
  Impl& my = *impl_;
  my.outline = &outline;
  my.snapshot = first;
  my.overlay->content().message.clear();
  if (!my.gl) return;
  my.objects.open(outline, meshes ? *meshes : *prepareMeshes(outline.meshes), themeOf(palette()));
  my.arrows.open(outline);
  // Poses first, then the floor below them, then the shadows upon it.
  findBodyStates(outline, my.snapshot, my.shown.bodies);
  my.objects.refresh(my.snapshot, my.shown.bodies, my.selection, my.options);
  my.room.fitTo(my.objects.bounds());
  my.objects.shadows().setFloorHeight(my.room.floorHeight());
  my.gl->dropBackdrop();
  my.refresh();
  my.camera.look(CameraPreset::kIso, my.objects.bounds());
  my.askForFrame();
}

void Viewport::close() {
  Impl& my = *impl_;
  my.outline = nullptr;
  my.snapshot = {};
  my.shown.bodies.clear();
  my.inside.setSource({});
  my.depth_views.cloud.show({}, CloudColours::kParts);
  my.mouse.held.reset();
  my.mouse.pull.reset();
  my.mouse.handled = -1;
  my.mouse.handles.release();
  my.fillOverlay();
  if (!my.gl) return;
  my.objects.open({}, {}, themeOf(palette()));
  my.arrows.open({});
  my.askForFrame();
}

void Viewport::refresh(const view::SceneSnapshot& snapshot) {
  Impl& my = *impl_;
  my.snapshot = snapshot;
  const bool changed = my.update();
  if (!my.gl || !isVisible()) return;
  if (changed) {
    my.noteChange();
    my.drawFrame(my.cheap_when_moving && my.rest_timer.isActive());
  } else {
    my.fillOverlay();
    my.overlay->update();
  }
}

long Viewport::shownStep() const { return impl_->shown.step; }

int Viewport::interval() const { return impl_->min_interval_ms; }

const ViewOptions& Viewport::options() const { return impl_->options; }

void Viewport::setTipSource(std::function<QString(int)> tip) { impl_->mouse.tip = std::move(tip); }

QString Viewport::tipAt(const QPoint& at) const {
  const Impl& my = *impl_;
  if (!my.gl || !my.outline || !my.mouse.tip) return {};
  const double scale = my.gl->devicePixelRatioF();
  const int object = my.objects.pick(at.x() * scale, (my.gl->height() - 1 - at.y()) * scale);
  return object < 0 ? QString() : my.mouse.tip(object);
}

void Viewport::setOptions(const ViewOptions& options) {
  impl_->options = options;
  impl_->room.setVisible(options.floor);
  if (impl_->gl) impl_->gl->dropBackdrop();
  impl_->refresh();
  impl_->askForFrame();
}

void Viewport::setObjectVisible(int object, bool visible) {
  impl_->objects.setVisible(object, visible);
  impl_->refresh();
  impl_->askForFrame();
}

void Viewport::setInsideSource(InsideOf source) {
  impl_->inside.setSource(std::move(source));
  impl_->refresh();
}

void Viewport::setInsideView(InsideView view, int level) {
  impl_->inside.setView(view, level);
  impl_->refresh();
  impl_->askForFrame();
}

InsideView Viewport::insideView() const { return impl_->inside.view(); }

int Viewport::insideLevel() const { return impl_->inside.level(); }

std::size_t Viewport::insideShown() const { return impl_->inside.shown(); }

void Viewport::showCloud(const std::vector<CloudPoint>& points, CloudColours colours) {
  Impl& my = *impl_;
  if (points.empty() && my.depth_views.cloud.shown() == 0) return;
  my.depth_views.cloud.show(points, colours);
  my.askForFrame();
}

void Viewport::showSensor(const Transform& X_W, const SensorKind& kind) {
  impl_->depth_views.sensor.show(X_W, kind);
  impl_->askForFrame();
}

void Viewport::hideSensor() {
  if (!impl_->depth_views.sensor.shown()) return;
  impl_->depth_views.sensor.hide();
  impl_->askForFrame();
}

std::vector<Vector3d> Viewport::sensorCorners() const {
  if (!impl_->depth_views.sensor.shown()) return {};
  const auto corners = impl_->depth_views.sensor.corners();
  return {corners.begin(), corners.end()};
}

std::size_t Viewport::cloudShown() const { return impl_->depth_views.cloud.shown(); }

void Viewport::look(CameraPreset preset) {
  impl_->camera.look(preset, impl_->objects.bounds());
  impl_->askForFrame();
  Q_EMIT cameraMoved();
}

void Viewport::fit() {
  impl_->camera.fit(impl_->objects.bounds());
  impl_->askForFrame();
  Q_EMIT cameraMoved();
}

void Viewport::fitSelection() {
  impl_->camera.fit(impl_->objects.bounds(impl_->selection.objects()));
  impl_->askForFrame();
  Q_EMIT cameraMoved();
}

void Viewport::orbit(double dx, double dy) {
  impl_->camera.orbit(dx, dy);
  impl_->askForFrame();
  Q_EMIT cameraMoved();
}

void Viewport::pan(double dx, double dy) {
  impl_->camera.pan(dx, dy);
  impl_->askForFrame();
  Q_EMIT cameraMoved();
}

void Viewport::zoom(double factor) {
  impl_->camera.zoom(factor);
  impl_->askForFrame();
  Q_EMIT cameraMoved();
}

CameraView Viewport::cameraView() const { return impl_->camera.view(); }

void Viewport::setCameraView(const CameraView& view) {
  impl_->camera.setView(view);
  impl_->askForFrame();
}

void Viewport::setResetKey(const QString& key) {
  QString& shown = impl_->overlay->content().reset_key;
  if (shown == key) return;
  shown = key;
  impl_->askForFrame();
}

void Viewport::setMessage(const QString& text) {
  impl_->overlay->content().message = text;
  impl_->overlay->update();
}

QImage Viewport::picture() {
  Impl& my = *impl_;
  if (!my.gl) return grab().toImage();
  my.rest_timer.stop();
  my.drawFrame(false);
  QImage image = my.gl->image();
  my.overlay->render(&image, QPoint(), QRegion(), QWidget::DrawChildren);
  return image;
}

QImage Viewport::preview(const view::MomentPoses& moment, int width) {
  Impl& my = *impl_;
  if (!my.gl || !my.outline || moment.objects.size() != my.outline->objects.size()) return {};
  view::SceneSnapshot then;
  for (const view::ObjectPose& object : moment.objects) {
    view::ObjectSnapshot& body = then.objects.emplace_back();
    body.X_WB = object.X_WB;
    body.pose_state = object.state;
  }
  const bool has_cloud = my.depth_views.cloud.shown() > 0;
  my.objects.refresh(then, {}, my.selection, my.options);
  my.depth_views.cloud.setVisible(false);
  my.front->DrawOff();
  my.room.setLeftOut(false);
  my.fitDepth();
  const int height = std::max(1, width * my.gl->height() / std::max(1, my.gl->width()));
  const QImage image = my.gl->drawn({width, height});
  my.front->DrawOn();
  my.depth_views.cloud.setVisible(has_cloud);
  my.objects.refresh(my.snapshot, my.shown.bodies, my.selection, my.options);
  return image;
}

const Overlay& Viewport::overlay() const { return *impl_->overlay; }

QPointF Viewport::project(const Vector3d& p_W) const {
  impl_->camera.update();
  return impl_->camera.project(p_W);
}

Vector3d Viewport::fromScreen(const Vector3d& direction) const {
  impl_->camera.update();
  return impl_->camera.fromScreen(direction);
}

void Viewport::showPull(const Vector3d& p_W, const Vector3d& target_W) {
  impl_->mouse.pull = {p_W, target_W};
  impl_->askForFrame();
}

void Viewport::hidePull() {
  impl_->mouse.pull.reset();
  impl_->askForFrame();
}

void Viewport::grabBody(const QPoint& at, bool poke) {
  Impl& my = *impl_;
  const double scale = my.gl->devicePixelRatioF();
  Vector3d p_W;
  const int object = my.objects.pick(at.x() * scale, (my.gl->height() - 1 - at.y()) * scale, &p_W);
  if (object < 0) return;
  my.mouse.held = p_W;
  my.mouse.pokes = poke;
  if (poke)
    Q_EMIT bodyPoked(object, p_W);
  else
    Q_EMIT bodyGrabbed(object, p_W);
}

void Viewport::moveMouse(const QMouseEvent& mouse) {
  Impl& my = *impl_;
  const QPoint moved = mouse.pos() - my.mouse.last;
  my.mouse.last = mouse.pos();
  if (pullHandle(mouse.pos())) return;
  if (my.mouse.held) {
    my.camera.update();
    const Vector3d to = my.camera.atDepthOf(*my.mouse.held, mouse.pos());
    if (my.mouse.pokes)
      Q_EMIT pokeMoved(to);
    else
      Q_EMIT bodyPulled(to);
  } else if (mouse.buttons() & Qt::LeftButton && mouse.modifiers() & Qt::AltModifier) {
    Q_EMIT scrubbed(static_cast<double>(moved.x()) / std::max(1, width()));
  } else if (mouse.buttons() & Qt::LeftButton && !(mouse.modifiers() & Qt::ShiftModifier)) {
    orbit(moved.x(), moved.y());
  } else if (mouse.buttons() != Qt::NoButton) {
    pan(moved.x(), moved.y());
  }
}

void Viewport::releaseMouse(const QMouseEvent& mouse) {
  Impl& my = *impl_;
  if (mouse.button() != Qt::LeftButton || releaseHandle()) return;
  if (my.mouse.held) {
    my.mouse.held.reset();
    if (my.mouse.pokes)
      Q_EMIT pokeEnded();
    else
      Q_EMIT bodyReleased();
    return;
  }
  if ((mouse.pos() - my.mouse.pressed).manhattanLength() > kClickSlack) return;
  const double scale = my.gl->devicePixelRatioF();
  const int object = my.objects.pick(mouse.x() * scale, (my.gl->height() - 1 - mouse.y()) * scale);
  if (object < 0)
    my.selection.clear();
  else
    my.selection.setObjects({object});
}

long Viewport::framesDrawn() const { return impl_->shown.frames; }

void Viewport::resizeEvent(QResizeEvent*) { impl_->resize(); }

void Viewport::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && impl_) impl_->setTheme();
  QWidget::changeEvent(event);
}

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
  Impl& my = *impl_;
  if (watched != my.gl) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      my.mouse.pressed = my.mouse.last = mouse->pos();
      const bool poke = mouse->modifiers() == (Qt::ControlModifier | Qt::ShiftModifier);
      if (mouse->button() == Qt::LeftButton && (poke || mouse->modifiers() == Qt::ControlModifier))
        grabBody(mouse->pos(), poke);
      else if (mouse->button() == Qt::LeftButton && mouse->modifiers() == Qt::NoModifier)
        grabHandle(mouse->pos());
      return true;
    }
    case QEvent::MouseMove:
      moveMouse(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseButtonRelease:
      releaseMouse(*static_cast<QMouseEvent*>(event));
      return true;
    case QEvent::MouseButtonDblClick:
      fitSelection();
      return true;
    case QEvent::Wheel: {
      const auto* wheel = static_cast<QWheelEvent*>(event);
      zoom(std::pow(kZoomPerNotch, wheel->angleDelta().y() / 120.0));
      return true;
    }
    case QEvent::ToolTip: {
      const auto* help = static_cast<QHelpEvent*>(event);
      const QString text = tipAt(help->pos());
      if (text.isEmpty())
        QToolTip::hideText();
      else
        QToolTip::showText(help->globalPos(), text, my.gl);
      return true;
    }
    case QEvent::Resize:
      // Its size may come later than that of the view around it. Drawn at once, so that picture, labels and
      // lines have the size that is painted next.
      my.resize();
      if (isVisible()) my.drawFrame(my.cheap_when_moving);
      return QWidget::eventFilter(watched, event);
    default:
      return QWidget::eventFilter(watched, event);
  }
}

}  // namespace abstand::ui
