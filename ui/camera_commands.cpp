// The commands that move the camera, its history, and a camera that follows.
#include "ui/camera_commands.hpp"

#include "ui/model/selection.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {
using Id = ActionId;
constexpr double kKeyStep = 24.0;  // px that a key moves the camera
constexpr double kKeyZoom = 1.15;
}  // namespace

CameraCommands::CameraCommands(const Actions& actions, Viewport& viewport, const Selection& selection,
                               QObject* parent)
    : QObject(parent), actions_{actions}, viewport_{viewport}, selection_{selection} {
  const auto on = [&](Id id, auto command) {
    connect(actions[id], &QAction::triggered, this, [&viewport, command] { command(viewport); });
  };
  on(Id::kFront, [](Viewport& view) { view.look(CameraPreset::kFront); });
  on(Id::kSide, [](Viewport& view) { view.look(CameraPreset::kSide); });
  on(Id::kTop, [](Viewport& view) { view.look(CameraPreset::kTop); });
  on(Id::kIso, [](Viewport& view) { view.look(CameraPreset::kIso); });
  on(Id::kOrbitLeft, [](Viewport& view) { view.orbit(kKeyStep, 0.0); });
  on(Id::kOrbitRight, [](Viewport& view) { view.orbit(-kKeyStep, 0.0); });
  on(Id::kOrbitUp, [](Viewport& view) { view.orbit(0.0, kKeyStep); });
  on(Id::kOrbitDown, [](Viewport& view) { view.orbit(0.0, -kKeyStep); });
  on(Id::kPanLeft, [](Viewport& view) { view.pan(kKeyStep, 0.0); });
  on(Id::kPanRight, [](Viewport& view) { view.pan(-kKeyStep, 0.0); });
  on(Id::kPanUp, [](Viewport& view) { view.pan(0.0, kKeyStep); });
  on(Id::kPanDown, [](Viewport& view) { view.pan(0.0, -kKeyStep); });
  on(Id::kZoomIn, [](Viewport& view) { view.zoom(1.0 / kKeyZoom); });
  on(Id::kZoomOut, [](Viewport& view) { view.zoom(kKeyZoom); });
  on(Id::kFit, [](Viewport& view) { view.fit(); });
  on(Id::kFitSelection, [](Viewport& view) { view.fitSelection(); });
  connect(actions[Id::kViewBack], &QAction::triggered, this, [this] { go(before_, after_); });
  connect(actions[Id::kViewForward], &QAction::triggered, this, [this] { go(after_, before_); });
  connect(actions[Id::kFollowSelection], &QAction::toggled, this, [this] { followed_.on = false; });
  moving_.setSingleShot(true);
  moving_.setInterval(kOneMovementMs);
  connect(&moving_, &QTimer::timeout, this, [this] { last_ = viewport_.cameraView(); });
  connect(&viewport, &Viewport::cameraMoved, this, &CameraCommands::noteMovement);
  forget();
}

void CameraCommands::forget() {
  before_.clear();
  after_.clear();
  moving_.stop();
  followed_.on = false;
  last_ = viewport_.cameraView();
  showHistory();
}

void CameraCommands::showHistory() {
  actions_[Id::kViewBack]->setEnabled(!before_.empty());
  actions_[Id::kViewForward]->setEnabled(!after_.empty());
}

void CameraCommands::noteMovement() {
  if (!moving_.isActive() && !(last_ == viewport_.cameraView())) {
    before_.push_back(last_);
    if (before_.size() > kMaxViews) before_.erase(before_.begin());
    after_.clear();
    showHistory();
  }
  moving_.start();
}

void CameraCommands::go(std::vector<CameraView>& from, std::vector<CameraView>& to) {
  if (from.empty()) return;
  to.push_back(viewport_.cameraView());
  last_ = from.back();
  from.pop_back();
  viewport_.setCameraView(last_);
  moving_.stop();
  showHistory();
}

void CameraCommands::follow(const view::SceneSnapshot& snapshot) {
  const std::vector<int>& objects = selection_.objects();
  if (!actions_[Id::kFollowSelection]->isChecked() || objects.empty()) {
    followed_.on = false;
    return;
  }
  Vector3d at = Vector3d::Zero();
  for (const int object : objects) {
    if (static_cast<std::size_t>(object) >= snapshot.objects.size()) return;
    at += snapshot.objects[static_cast<std::size_t>(object)].p_WCom / static_cast<double>(objects.size());
  }
  if (!at.allFinite()) return;
  if (followed_.on && followed_.objects == objects && at != followed_.at) {
    CameraView view = viewport_.cameraView();
    view.focus += at - followed_.at;
    viewport_.setCameraView(view);
    if (!moving_.isActive()) last_ = view;
  }
  followed_ = {objects, at, true};
}

}  // namespace abstand::ui
