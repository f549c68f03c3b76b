#include "ui/report_commands.hpp"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QUrl>

#include "ui/model/recent_folder.hpp"
#include "ui/panels/report_dialog.hpp"

namespace abstand::ui {

ReportCommands::ReportCommands(QWidget* window) : QObject(window), window_(window) {
  qRegisterMetaType<abstand::ui::ReportRequest>();
}

void ReportCommands::ask(const std::string& margin_set, const QString& scene_name,
                         const WhatIfSettings& what_if) {
  if (wait_) {
    wait_->raise();
    return;
  }
  last_.margin_set = margin_set;
  last_.what_if = what_if;
  if (last_.file.isEmpty())
    last_.file =
        QDir(recentFolder())
            .absoluteFilePath(QFileInfo(scene_name).completeBaseName() + QStringLiteral("_report.html"));
  ReportDialog dialog(last_, window_);
  if (dialog.exec() != QDialog::Accepted) return;
  last_ = dialog.request();
  wait_ = new QProgressDialog(tr("Making the report…"), tr("Cancel"), 0, 0, window_);
  wait_->setObjectName(QStringLiteral("report_wait"));
  wait_->setWindowTitle(tr("Report"));
  wait_->setAttribute(Qt::WA_DeleteOnClose);
  wait_->setWindowModality(Qt::NonModal);
  wait_->setMinimumDuration(0);
  connect(wait_, &QProgressDialog::canceled, this, [this] {
    endWait();
    Q_EMIT cancelled();
  });
  wait_->show();
  Q_EMIT wanted(last_);
}

void ReportCommands::endWait() {
  if (!wait_) return;
  wait_->disconnect(this);
  wait_->close();
  wait_.clear();
}

void ReportCommands::done(const QString& file) {
  endWait();
  auto* box = new QMessageBox(QMessageBox::Information, tr("Report"),
                              tr("The report was written to\n%1").arg(QDir::toNativeSeparators(file)),
                              QMessageBox::Close, window_);
  box->setObjectName(QStringLiteral("report_done"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QPushButton* open = box->addButton(tr("&Open"), QMessageBox::AcceptRole);
  box->setDefaultButton(open);
  connect(open, &QPushButton::clicked, this,
          [file] { QDesktopServices::openUrl(QUrl::fromLocalFile(file)); });
  box->open();
}

void ReportCommands::fail(const QString& problem) {
  endWait();
  Q_EMIT failed(tr("No report"), problem);
}

}  // namespace abstand::ui
