#include "ui/live_camera_commands.hpp"

#include "ui/panels/live_camera_dialog.hpp"

namespace abstand::ui {

LiveCameraCommands::LiveCameraCommands(QWidget* window) : QObject(window), window_(window) {
  qRegisterMetaType<abstand::ui::LiveCameraRequest>();
}

void LiveCameraCommands::setScene(const QString& scene, const view::SceneOutline& outline) {
  people_.clear();
  for (const view::SceneOutline::ObjectInfo& object : outline.objects)
    if (object.human) people_ << QString::fromStdString(object.name).section(QLatin1Char('/'), 0, 0);
  people_.removeDuplicates();
  if (!scene.isEmpty()) last_.scene = scene;
  if (!people_.isEmpty() && !people_.contains(last_.person)) last_.person = people_.constFirst();
}

void LiveCameraCommands::open() {
  if (!dialog_) {
    dialog_ = new LiveCameraDialog(window_);
    dialog_->setRequest(last_, people_);
    connect(dialog_, &LiveCameraDialog::wanted, this, [this](const LiveCameraRequest& request) {
      last_ = request;
      Q_EMIT wanted(request);
    });
    connect(dialog_, &LiveCameraDialog::cancelled, this, &LiveCameraCommands::cancelled);
    dialog_->show();
  }
  dialog_->raise();
  dialog_->activateWindow();
}

LiveCameraDialog* LiveCameraCommands::dialog() const { return dialog_; }

void LiveCameraCommands::say(const QString& progress) {
  if (dialog_ && dialog_->waiting()) dialog_->say(progress);
}

void LiveCameraCommands::succeed() {
  if (!dialog_ || !dialog_->waiting()) return;
  dialog_->fail({});  // Closing would stop the camera while it waits.
  dialog_->close();
}

void LiveCameraCommands::fail(const QString& problem) {
  if (dialog_ && dialog_->waiting()) dialog_->fail(problem);
}

}  // namespace abstand::ui
