#include "ui/calibration_commands.hpp"

#include <QFile>
#include <QFileDialog>

#include "core/base/output_file.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/panels/calibration_dialog.hpp"

namespace abstand::ui {

CalibrationCommands::CalibrationCommands(QWidget* window) : QObject(window), window_(window) {
  qRegisterMetaType<abstand::ui::CalibrationRequest>();
  qRegisterMetaType<abstand::ui::CalibrationAnswer>();
}

/// A dialog that is open is about the scene before.
void CalibrationCommands::setRobots(const QStringList& robots) {
  if (robots == robots_) return;
  robots_ = robots;
  if (dialog_) dialog_->close();
}

void CalibrationCommands::open() {
  if (!dialog_) {
    dialog_ = new CalibrationDialog(robots_, window_);
    dialog_->setRequest(last_);
    connect(dialog_, &CalibrationDialog::wanted, this, [this](const CalibrationRequest& request) {
      last_ = request;
      Q_EMIT wanted(request);
    });
    connect(dialog_, &CalibrationDialog::cancelled, this, &CalibrationCommands::cancelled);
    connect(dialog_, &CalibrationDialog::saveWanted, this, &CalibrationCommands::save);
    dialog_->QDialog::show();
  }
  dialog_->raise();
  dialog_->activateWindow();
}

CalibrationDialog* CalibrationCommands::dialog() const { return dialog_; }

void CalibrationCommands::save(const QByteArray& camera) {
  QFileDialog files(window_, tr("Save camera file"), recentFolder(), tr("Camera files (*.yaml)"));
  files.setObjectName(QStringLiteral("save_camera"));
  files.setAcceptMode(QFileDialog::AcceptSave);
  files.setDefaultSuffix(QStringLiteral("yaml"));
  files.selectFile(QStringLiteral("camera.yaml"));
  if (files.exec() != QDialog::Accepted || files.selectedFiles().isEmpty()) return;
  const QString file = files.selectedFiles().constFirst();
  rememberFolder(file);
  try {
    writeFile(QFile::encodeName(file).toStdString(), camera.toStdString());
    Q_EMIT said(tr("Saved %1").arg(file));
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Cannot save"), QString::fromUtf8(e.what()));
  }
}

void CalibrationCommands::done(const CalibrationAnswer& answer) {
  if (dialog_ && dialog_->waiting()) dialog_->show(answer);
}

void CalibrationCommands::fail(const QString& problem) {
  if (dialog_ && dialog_->waiting()) dialog_->fail(problem);
}

}  // namespace abstand::ui
