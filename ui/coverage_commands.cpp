#include "ui/coverage_commands.hpp"

#include <QFileDialog>
#include <QTimer>
#include <algorithm>

#include "ui/document/document.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/panels/coverage_dialog.hpp"
#include "ui/panels/lens_kind.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

CoverageCommands::CoverageCommands(const Parts& parts, QWidget* window)
    : QObject(window), parts_(parts), window_(window), gather_{new QTimer(this)} {
  qRegisterMetaType<abstand::ui::SensorPlan>();
  qRegisterMetaType<abstand::ui::CoverageReport>();
  gather_->setSingleShot(true);
  gather_->setInterval(kGatherMs);
  connect(gather_, &QTimer::timeout, this, &CoverageCommands::ask);
  connect(&parts_.document, &Document::workChanged, this, [this](const Work& before, const Work& after) {
    if (before.sensor != after.sensor || before.things != after.things) follow();
  });
  connect(&parts_.document, &Document::opened, this, &CoverageCommands::follow);
  connect(&parts_.playback, &Playback::timeChanged, this, [this](double t) {
    if (dialog_) dialog_->setTime(t);
  });
}

void CoverageCommands::open(bool can) {
  can_ = can;
  if (!can && dialog_) dialog_->close();
  follow();
}

void CoverageCommands::plan() {
  if (!can_ || kinds_.empty()) return;
  if (!parts_.document.work().sensor) placeAtView();
  if (!dialog_) {
    dialog_ = new CoverageDialog(kinds_, window_);
    connect(dialog_, &CoverageDialog::planEdited, this, [this](const SensorPlan& plan) {
      edit(tr("planned depth camera"), plan, QStringLiteral("sensor"));
    });
    connect(dialog_, &CoverageDialog::viewWanted, this, &CoverageCommands::placeAtView);
    connect(dialog_, &CoverageDialog::fileWanted, this, &CoverageCommands::askFile);
    connect(dialog_, &CoverageDialog::removeWanted, this, &CoverageCommands::remove);
    connect(dialog_, &CoverageDialog::stopped, this, &CoverageCommands::cancelled);
    connect(dialog_, &CoverageDialog::picked, &parts_.playback, &Playback::seek);
    dialog_->setTime(parts_.playback.time());
    dialog_->QDialog::show();
    follow();
  }
  dialog_->raise();
  dialog_->activateWindow();
}

CoverageDialog* CoverageCommands::dialog() const { return dialog_; }

void CoverageCommands::edit(const QString& text, const SensorPlan& plan, const QString& merge_key) {
  parts_.document.edit(
      text, [&](Work& work) { work.sensor = plan; }, merge_key);
}

void CoverageCommands::placeAtView() {
  const SensorPlan plan = parts_.document.work().sensor.value_or(SensorPlan());
  edit(tr("depth camera at the view"), fromView(plan, parts_.viewport.cameraView()));
}

void CoverageCommands::askFile() {
  QFileDialog dialog(window_, tr("Open camera file"), recentFolder(), tr("Camera files (*.yaml *.yml)"));
  dialog.setObjectName(QStringLiteral("open_camera"));
  dialog.setFileMode(QFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  rememberFolder(dialog.selectedFiles().constFirst());
  Q_EMIT cameraFileWanted(dialog.selectedFiles().constFirst());
}

void CoverageCommands::takeCamera(const SensorLens& lens, const std::optional<Transform>& X_W) {
  SensorPlan plan = parts_.document.work().sensor.value_or(SensorPlan());
  plan.sensor = kFileSensor;
  plan.lens = lens;
  edit(tr("depth camera of a file"), X_W ? withPose(plan, *X_W) : plan);
}

void CoverageCommands::remove() {
  parts_.document.edit(tr("remove the depth camera"), [](Work& work) { work.sensor.reset(); });
}

void CoverageCommands::follow() {
  showSensor();
  const std::optional<SensorPlan>& plan = parts_.document.work().sensor;
  if (!dialog_) return;
  if (!plan) {
    dialog_->close();
    return;
  }
  dialog_->setPlan(*plan);
  if (!can_) return;
  dialog_->wait();
  Q_EMIT cancelled();
  gather_->start();
}

void CoverageCommands::showSensor() {
  const std::optional<SensorPlan>& plan = parts_.document.work().sensor;
  if (can_ && plan && plan->lens && plan->sensor == kFileSensor)
    return parts_.viewport.showSensor(plan->X_W(), kindOf(*plan->lens, kFileSensor));
  const auto kind = std::find_if(kinds_.begin(), kinds_.end(),
                                 [&](const SensorKind& each) { return plan && each.name == plan->sensor; });
  if (can_ && kind != kinds_.end())
    parts_.viewport.showSensor(plan->X_W(), *kind);
  else
    parts_.viewport.hideSensor();
}

void CoverageCommands::ask() {
  const std::optional<SensorPlan>& plan = parts_.document.work().sensor;
  if (dialog_ && dialog_->waiting() && plan) Q_EMIT wanted(*plan);
}

void CoverageCommands::showProgress(int done, int all) {
  if (dialog_) dialog_->showProgress(done, all);
}

void CoverageCommands::done(const CoverageReport& report) {
  if (dialog_ && dialog_->waiting()) dialog_->show(report);
}

void CoverageCommands::fail(const QString& problem) {
  if (dialog_ && dialog_->waiting()) dialog_->fail(problem);
}

}  // namespace abstand::ui
