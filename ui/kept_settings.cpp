// What of the window outlives the program.
#include "ui/kept_settings.hpp"

#include <QMainWindow>
#include <QSettings>
#include <QSlider>

#include "ui/dock_set.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

using Id = ActionId;

/// Those whose state is the user's taste and outlives the program.
struct Remembered {
  Id id;
  const char* key;
};
constexpr Remembered kRemembered[] = {{Id::kForces, "view/forces"},
                                      {Id::kTorques, "view/torques"},
                                      {Id::kJointTorques, "view/joint_torques"},
                                      {Id::kVelocities, "view/velocities"},
                                      {Id::kClosest, "view/closest"},
                                      {Id::kLabels, "view/labels"},
                                      {Id::kFloor, "view/floor"},
                                      {Id::kShadows, "view/shadows"},
                                      {Id::kLoop, "playback/loop"},
                                      {Id::kTransparent, "view/transparent"},
                                      {Id::kAutoScale, "view/auto_scale"},
                                      {Id::kMetres, "view/metres"},
                                      {Id::kRadians, "view/radians"},
                                      {Id::kClockTime, "view/clock_time"},
                                      {Id::kDepthBody, "view/depth_body"},
                                      {Id::kCloud, "view/cloud"},
                                      {Id::kCloudConfidence, "view/cloud_confidence"},
                                      {Id::kCloudAll, "view/cloud_all"}};

}  // namespace

bool restoreSettings(QMainWindow& window, const Actions& actions, QSlider& opacity) {
  const QSettings settings;
  window.restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  const bool laid_out = window.restoreState(settings.value(QStringLiteral("window/state")).toByteArray(),
                                            DockSet::kLayoutVersion);
  for (const auto& [id, key] : kRemembered) {
    QAction* action = actions[id];
    action->setChecked(settings.value(QString::fromLatin1(key), action->isChecked()).toBool());
  }
  opacity.setValue(settings.value(QStringLiteral("view/opacity"), opacity.value()).toInt());
  return laid_out;
}

void saveSettings(const QMainWindow& window, const Actions& actions, const QSlider& opacity) {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), window.saveGeometry());
  settings.setValue(QStringLiteral("window/state"), window.saveState(DockSet::kLayoutVersion));
  for (const auto& [id, key] : kRemembered)
    settings.setValue(QString::fromLatin1(key), actions[id]->isChecked());
  settings.setValue(QStringLiteral("view/opacity"), opacity.value());
}

}  // namespace abstand::ui
