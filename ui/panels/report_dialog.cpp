#include "ui/panels/report_dialog.hpp"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/model/recent_folder.hpp"
#include "ui/style/number_box.hpp"

namespace abstand::ui {

namespace {

constexpr int kDialogWidth = 520;  // px

QDoubleSpinBox* numberField(double value, double min, double max, double step, const QString& unit,
                            const QString& tip) {
  auto* box = new NumberBox;
  box->setDecimals(3);
  box->setRange(min, max);
  box->setSingleStep(step);
  box->setSuffix(unit);
  box->setValue(value);
  box->setToolTip(tip);
  return box;
}

}  // namespace

ReportDialog::ReportDialog(const ReportRequest& request, QWidget* parent)
    : QDialog(parent), first_(request), file_{new QLineEdit(request.file, this)} {
  setObjectName(QStringLiteral("report"));
  setWindowTitle(tr("Report"));
  resize(kDialogWidth, 0);
  limit_ = numberField(request.what_if.limit, 0.0, 10.0, 0.01, tr(" m"),
                       tr("Clearance that a moving robot must keep; 0: no contact"));
  reaction_ = numberField(request.what_if.reaction_time, 0.0, 100.0, 0.01, tr(" s"),
                          tr("From the frame that breaks a margin until the robot slows down"));
  deceleration_ = numberField(request.what_if.deceleration, 0.001, 1e4, 0.5, tr(" rad/s² or m/s²"),
                              tr("Of every joint, on the path of its motion"));
  restart_ = numberField(request.what_if.restart_time, 0.0, 1000.0, 0.1, tr(" s"),
                         tr("From the end of an intrusion until the robot resumes"));
  auto* head = new QLabel(
      tr("A report to read and sign: the outcome of the present margins over the whole "
         "recording, the smallest safe margins and permitted speeds, the worst moments with pictures, and "
         "the assumptions. It is made by \"abstand tune\" and can take a minute."),
      this);
  head->setWordWrap(true);
  auto* browse = new QPushButton(tr("&Browse…"), this);
  auto* place = new QHBoxLayout;
  place->addWidget(file_, 1);
  place->addWidget(browse);
  auto* form = new QFormLayout;
  form->addRow(tr("&File"), place);
  form->addRow(tr("Clearance &limit"), limit_);
  form->addRow(tr("&Reaction time"), reaction_);
  form->addRow(tr("&Deceleration"), deceleration_);
  form->addRow(tr("Re&start time"), restart_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  make_ = buttons->addButton(tr("&Make report"), QDialogButtonBox::AcceptRole);
  make_->setDefault(true);
  file_->setAccessibleName(tr("File of the report"));
  const auto check = [this] { make_->setEnabled(!file_->text().trimmed().isEmpty()); };
  connect(file_, &QLineEdit::textChanged, this, check);
  check();
  connect(browse, &QPushButton::clicked, this, &ReportDialog::chooseFile);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(head);
  layout->addLayout(form);
  layout->addWidget(buttons);
}

void ReportDialog::chooseFile() {
  QFileDialog dialog(this, tr("File of the report"), recentFolder(),
                     tr("Web pages (*.html);;PDF documents (*.pdf)"));
  dialog.setObjectName(QStringLiteral("report_file"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("html"));
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.section(QLatin1String("*."), 1).chopped(1));
  });
  dialog.selectFile(QFileInfo(file_->text()).fileName());
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  file_->setText(dialog.selectedFiles().constFirst());
  rememberFolder(file_->text());
}

ReportRequest ReportDialog::request() const {
  ReportRequest request = first_;
  request.file = QFileInfo(file_->text().trimmed()).absoluteFilePath();
  request.what_if.limit = limit_->value();
  request.what_if.reaction_time = reaction_->value();
  request.what_if.deceleration = deceleration_->value();
  request.what_if.restart_time = restart_->value();
  return request;
}

}  // namespace abstand::ui
