#include "ui/panels/speed_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

#include "ui/model/recent_folder.hpp"
#include "ui/style/format.hpp"
#include "ui/style/number_box.hpp"

namespace abstand::ui {

namespace {

enum SpeedColumn { kSpeedSegment, kSpeedShare, kSpeedLimitedBy, kBySeparation, kByContact, kSpeedColumns };

QString speedPercent(double share) { return SpeedDialog::tr("%1 %").arg(fixed(100.0 * share, 0)); }

QString speedLimitText(const SpeedRow& row) {
  if (!row.limited) return SpeedDialog::tr("nothing");
  const QString what =
      row.by_contact_limit ? SpeedDialog::tr("limits of a contact") : SpeedDialog::tr("protective distance");
  return SpeedDialog::tr("%1: %2 at %3").arg(what, row.part, secondsWithUnit(row.t));
}

QString speedOutcome(const SpeedProposal& proposal) {
  QString text =
      std::isfinite(proposal.permitted)
          ? SpeedDialog::tr("The program takes %1 instead of %2.")
                .arg(secondsWithUnit(proposal.permitted), secondsWithUnit(proposal.recorded))
          : SpeedDialog::tr("The robot would have to stand where the speed is 0 %: there is no program.");
  for (const QString& file : proposal.files)
    text += QLatin1Char('\n') + SpeedDialog::tr("Saved %1").arg(QDir::toNativeSeparators(file));
  if (!proposal.not_written.isEmpty())
    text += QLatin1Char('\n') + SpeedDialog::tr("No motion was saved: %1").arg(proposal.not_written);
  return text;
}

}  // namespace

SpeedDialog::SpeedDialog(QWidget* parent)
    : QDialog(parent),
      rule_{new QComboBox(this)},
      segment_{new NumberBox(this)},
      sentence_{new QLabel(this)},
      table_{new QTableWidget(0, kSpeedColumns, this)},
      busy_{new QProgressBar(this)} {
  setObjectName(QStringLiteral("speeds"));
  setWindowTitle(tr("Proposed speeds"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(640, 460);
  auto* head = new QLabel(
      tr("The highest share of its speed in each segment of the robots' program at which no recorded person "
         "would have broken a limit, as \"abstand tune\" computes it. It holds for this recording alone and "
         "replaces no risk assessment."),
      this);
  head->setWordWrap(true);
  rule_->addItem(tr("Protective distance and contact limits"), QStringLiteral("both"));
  rule_->addItem(tr("Protective distance alone"), QStringLiteral("separation"));
  rule_->addItem(tr("Contact limits alone"), QStringLiteral("contact"));
  segment_->setObjectName(QStringLiteral("segment"));
  segment_->setRange(0.01, 1e4);
  segment_->setDecimals(2);
  segment_->setValue(SpeedRequest().segment);
  segment_->setSuffix(tr(" s"));
  auto* form = new QFormLayout;
  form->addRow(tr("&Rule"), rule_);
  form->addRow(tr("&Length of a segment"), segment_);
  table_->setHorizontalHeaderLabels(
      {tr("Segment"), tr("Speed"), tr("Limited by"), tr("By distance"), tr("By contact")});
  table_->setAccessibleName(tr("Permitted speeds"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kSpeedLimitedBy, QHeaderView::Stretch);
  connect(table_, &QTableWidget::cellActivated, this, [this](int row, int) {
    const SpeedRow& picked_row = shown_.rows[static_cast<std::size_t>(row)];
    Q_EMIT picked(picked_row.limited ? picked_row.t : picked_row.t0);
  });
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  busy_->setRange(0, 0);
  busy_->setAccessibleName(tr("The speeds are being computed"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  compute_ = buttons->addButton(tr("&Compute"), QDialogButtonBox::ActionRole);
  save_ = buttons->addButton(tr("&Save motion…"), QDialogButtonBox::ActionRole);
  stop_ = buttons->addButton(tr("S&top"), QDialogButtonBox::ActionRole);
  compute_->setDefault(true);
  save_->setToolTip(
      tr("Replays the slower program beside the recording until no limit is broken, and saves it "
         "as motion files"));
  connect(compute_, &QPushButton::clicked, this, [this] { ask({}); });
  connect(save_, &QPushButton::clicked, this, &SpeedDialog::askFolder);
  connect(stop_, &QPushButton::clicked, this, &SpeedDialog::stopWaiting);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this, &QDialog::finished, this, &SpeedDialog::stopWaiting);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(head);
  layout->addLayout(form);
  layout->addWidget(table_, 1);
  layout->addWidget(sentence_);
  layout->addWidget(busy_);
  layout->addWidget(buttons);
  setWaiting(false);
}

void SpeedDialog::setWaiting(bool waiting) {
  waiting_ = waiting;
  busy_->setVisible(waiting);
  for (QWidget* each : std::initializer_list<QWidget*>{compute_, save_, rule_, segment_})
    each->setEnabled(!waiting);
  stop_->setEnabled(waiting);
}

void SpeedDialog::stopWaiting() {
  if (!waiting_) return;
  setWaiting(false);
  sentence_->setText(tr("Stopped."));
  Q_EMIT cancelled();
}

void SpeedDialog::ask(const QString& folder) {
  setWaiting(true);
  sentence_->setText(folder.isEmpty() ? tr("Computing distances and speeds…")
                                      : tr("Replaying the slower program…"));
  Q_EMIT wanted({rule_->currentData().toString(), segment_->value(), folder});
}

void SpeedDialog::askFolder() {
  QFileDialog dialog(this, tr("Folder for the motions"), recentFolder());
  dialog.setObjectName(QStringLiteral("speed_folder"));
  dialog.setFileMode(QFileDialog::Directory);
  dialog.setOption(QFileDialog::ShowDirsOnly);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  rememberFolder(dialog.selectedFiles().constFirst());
  // A folder of its own: it is written whole or not at all.
  ask(QDir(dialog.selectedFiles().constFirst()).filePath(QStringLiteral("permitted_speeds")));
}

void SpeedDialog::show(const SpeedProposal& proposal) {
  setWaiting(false);
  shown_ = proposal;
  table_->setRowCount(static_cast<int>(proposal.rows.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const SpeedRow& row = proposal.rows[static_cast<std::size_t>(i)];
    const auto set = [&](SpeedColumn column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      if (column != kSpeedSegment && column != kSpeedLimitedBy)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setToolTip(speedLimitText(row));
      table_->setItem(i, column, item);
    };
    set(kSpeedSegment, tr("%1 – %2").arg(secondsWithUnit(row.t0), secondsWithUnit(row.t1)));
    set(kSpeedShare, speedPercent(row.scale));
    set(kSpeedLimitedBy, speedLimitText(row));
    set(kBySeparation, speedPercent(row.by_separation));
    set(kByContact, speedPercent(row.by_contact));
  }
  sentence_->setText(speedOutcome(proposal));
}

void SpeedDialog::fail(const QString& problem) {
  setWaiting(false);
  sentence_->setText(problem);
}

}  // namespace abstand::ui
