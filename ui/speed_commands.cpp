#include "ui/speed_commands.hpp"

#include "ui/panels/speed_dialog.hpp"

namespace abstand::ui {

SpeedCommands::SpeedCommands(QWidget* window) : QObject(window), window_(window) {
  qRegisterMetaType<abstand::ui::SpeedRequest>();
  qRegisterMetaType<abstand::ui::SpeedProposal>();
}

void SpeedCommands::open() {
  if (!dialog_) {
    dialog_ = new SpeedDialog(window_);
    connect(dialog_, &SpeedDialog::wanted, this, &SpeedCommands::wanted);
    connect(dialog_, &SpeedDialog::cancelled, this, &SpeedCommands::cancelled);
    connect(dialog_, &SpeedDialog::picked, this, &SpeedCommands::picked);
    dialog_->QDialog::show();
  }
  dialog_->raise();
  dialog_->activateWindow();
}

SpeedDialog* SpeedCommands::dialog() const { return dialog_; }

void SpeedCommands::close() {
  if (dialog_) dialog_->close();
}

void SpeedCommands::done(const SpeedProposal& proposal) {
  if (dialog_) dialog_->show(proposal);
}

void SpeedCommands::fail(const QString& problem) {
  if (dialog_) dialog_->fail(problem);
}

}  // namespace abstand::ui
