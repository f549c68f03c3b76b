// Handles of a body in the 3D view, and the mouse on them.
#include "ui/viewport/viewport_impl.hpp"

namespace abstand::ui {

std::optional<Vector3d> Viewport::Impl::handleCentre() const {
  const auto i = static_cast<std::size_t>(mouse.handled);
  if (!outline || mouse.handled < 0 || i >= snapshot.objects.size()) return {};
  return snapshot.objects[i].p_WCom;
}

void Viewport::Impl::addHandles() {
  overlay->content().handles.reset();
  if (const auto centre = handleCentre()) overlay->content().handles = mouse.handles.drawing(camera, *centre);
}

void Viewport::setHandles(int object) {
  Impl& my = *impl_;
  if (my.mouse.handled == object) return;
  my.mouse.handled = object;
  my.mouse.handles.release();
  my.askForFrame();
}

bool Viewport::grabHandle(const QPoint& at) {
  Impl& my = *impl_;
  const auto centre = my.handleCentre();
  if (!centre) return false;
  my.camera.update();
  if (!my.mouse.handles.grab(my.camera, *centre, at)) return false;
  Q_EMIT handleGrabbed(my.mouse.handled, *centre);
  return true;
}

bool Viewport::pullHandle(const QPoint& at) {
  Impl& my = *impl_;
  if (!my.mouse.handles.isHeld()) return false;
  my.camera.update();
  const HandlePull pull = my.mouse.handles.pull(my.camera, at);
  Q_EMIT handlePulled(pull.shift, pull.turn);
  return true;
}

bool Viewport::releaseHandle() {
  Impl& my = *impl_;
  if (!my.mouse.handles.isHeld()) return false;
  my.mouse.handles.release();
  my.askForFrame();
  Q_EMIT handleReleased();
  return true;
}

}  // namespace abstand::ui
