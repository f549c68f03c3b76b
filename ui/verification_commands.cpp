#include "ui/verification_commands.hpp"

#include "ui/panels/verification_dialog.hpp"

namespace abstand::ui {

VerificationCommands::VerificationCommands(QWidget* window) : QObject(window), window_(window) {
  qRegisterMetaType<abstand::ui::VerificationRequest>();
  qRegisterMetaType<abstand::ui::VerificationNews>();
}

void VerificationCommands::open() {
  if (!dialog_) {
    dialog_ = new VerificationDialog(families_, window_);
    connect(dialog_, &VerificationDialog::wanted, this, &VerificationCommands::wanted);
    connect(dialog_, &VerificationDialog::cancelled, this, &VerificationCommands::cancelled);
    connect(dialog_, &VerificationDialog::pageWanted, this, &VerificationCommands::pageWanted);
    dialog_->show();
  }
  dialog_->raise();
  dialog_->activateWindow();
}

VerificationDialog* VerificationCommands::dialog() const { return dialog_; }

void VerificationCommands::add(const VerificationNews& news) {
  if (dialog_) dialog_->add(news);
}

void VerificationCommands::fail(const QString& problem) {
  if (dialog_) dialog_->fail(problem);
}

void VerificationCommands::say(const QString& text) {
  if (dialog_) dialog_->say(text);
}

}  // namespace abstand::ui
