#include "ui/panels/verification_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

#include "ui/model/recent_folder.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

enum CheckColumn {
  kCheckName,
  kCheckOutcome,
  kCheckPoses,
  kCheckMedian,
  kCheckP99,
  kCheckWorst,
  kCheckLimit,
  kCheckColumns
};

constexpr int kProgressSteps = 1000;

/// Three digits are enough to compare with a limit.
QString checkNumber(double value) {
  return std::isnan(value) ? QStringLiteral("–") : QLocale().toString(value, 'g', 3);
}

}  // namespace

VerificationDialog::VerificationDialog(const QStringList& families, QWidget* parent)
    : QDialog(parent),
      family_{new QComboBox(this)},
      extent_{new QComboBox(this)},
      sentence_{new QLabel(this)},
      table_{new QTableWidget(0, kCheckColumns, this)},
      progress_{new QProgressBar(this)} {
  setObjectName(QStringLiteral("verification"));
  setWindowTitle(tr("Verification of the engine"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(760, 560);
  auto* head = new QLabel(
      tr("Checks on this machine, as \"abstand verify\" makes them: distances against brute force, forces "
         "against closed forms, the same bits on any number of threads. A check passes if none of its poses "
         "exceeds the limit. The tip of a row says what is tested and why the limit is what it is."),
      this);
  head->setWordWrap(true);
  extent_->addItem(tr("Quick: 3,000 poses, about a minute"), true);
  extent_->addItem(tr("Complete: 100,000 poses, some minutes"), false);
  family_->setObjectName(QStringLiteral("family"));
  family_->addItem(tr("All"), QString());
  for (const QString& family : families) family_->addItem(family, family);
  auto* form = new QFormLayout;
  form->addRow(tr("C&hecks"), family_);
  form->addRow(tr("&Extent"), extent_);
  table_->setHorizontalHeaderLabels(
      {tr("Check"), tr("Outcome"), tr("Poses"), tr("Median"), tr("99 %"), tr("Worst"), tr("Limit")});
  table_->setAccessibleName(tr("Checks of the engine"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kCheckName, QHeaderView::Stretch);
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  progress_->setRange(0, kProgressSteps);
  progress_->setAccessibleName(tr("Progress of the checks"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  start_ = buttons->addButton(tr("&Start"), QDialogButtonBox::ActionRole);
  save_ = buttons->addButton(tr("Save &page…"), QDialogButtonBox::ActionRole);
  stop_ = buttons->addButton(tr("S&top"), QDialogButtonBox::ActionRole);
  start_->setDefault(true);
  save_->setToolTip(tr("Saves the results with tables and plots as an HTML page"));
  connect(start_, &QPushButton::clicked, this, &VerificationDialog::ask);
  connect(save_, &QPushButton::clicked, this, &VerificationDialog::askFile);
  connect(stop_, &QPushButton::clicked, this, &VerificationDialog::stopWaiting);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this, &QDialog::finished, this, &VerificationDialog::stopWaiting);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(head);
  layout->addLayout(form);
  layout->addWidget(table_, 1);
  layout->addWidget(sentence_);
  layout->addWidget(progress_);
  layout->addWidget(buttons);
  setWaiting(false);
}

void VerificationDialog::setWaiting(bool waiting) {
  waiting_ = waiting;
  progress_->setVisible(waiting);
  start_->setEnabled(!waiting);
  extent_->setEnabled(!waiting);
  family_->setEnabled(!waiting);
  save_->setEnabled(complete_);
  stop_->setEnabled(waiting);
}

void VerificationDialog::ask() {
  table_->setRowCount(0);
  failed_ = 0;
  complete_ = false;
  progress_->setValue(0);
  setWaiting(true);
  sentence_->setText(tr("Checking…"));
  Q_EMIT wanted({extent_->currentData().toBool(), family_->currentData().toString()});
}

void VerificationDialog::askFile() {
  QFileDialog dialog(this, tr("Save the page"), recentFolder(), tr("HTML pages (*.html)"));
  dialog.setObjectName(QStringLiteral("verification_page"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("html"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString file = dialog.selectedFiles().constFirst();
  rememberFolder(QFileInfo(file).absolutePath());
  Q_EMIT pageWanted(file);
}

void VerificationDialog::stopWaiting() {
  if (!waiting_) return;
  setWaiting(false);
  sentence_->setText(tr("Stopped: the checks are incomplete."));
  Q_EMIT cancelled();
}

void VerificationDialog::addRow(const VerificationRow& row) {
  const int at = table_->rowCount();
  table_->insertRow(at);
  const auto set = [&](CheckColumn column, const QString& text) {
    auto* item = new QTableWidgetItem(text);
    if (column > kCheckOutcome) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setToolTip(tr("%1\nNumbers: %2\nLimit: %3").arg(row.what, row.quantity, row.reason));
    table_->setItem(at, column, item);
    return item;
  };
  set(kCheckName, row.name);
  QTableWidgetItem* outcome =
      set(kCheckOutcome,
          row.passed ? tr("passed") : tr("⚠ %n breaches", nullptr, static_cast<int>(row.breaches)));
  if (!row.passed) {
    QFont font = outcome->font();
    font.setBold(true);
    outcome->setFont(font);
    outcome->setForeground(QColor(kVermillion));
    ++failed_;
  }
  set(kCheckPoses, QLocale().toString(row.poses));
  set(kCheckMedian, checkNumber(row.p50));
  set(kCheckP99, checkNumber(row.p99));
  set(kCheckWorst, checkNumber(row.worst));
  set(kCheckLimit, checkNumber(row.limit));
}

void VerificationDialog::add(const VerificationNews& news) {
  if (!waiting_) return;
  for (const VerificationRow& row : news.rows) addRow(row);
  if (!news.rows.empty()) table_->scrollToBottom();
  progress_->setValue(static_cast<int>(kProgressSteps * news.share));
  if (!news.ended) {
    if (!news.family.isEmpty()) sentence_->setText(tr("Checking: %1").arg(news.family));
    return;
  }
  complete_ = true;
  setWaiting(false);
  sentence_->setText(news.passed
                         ? tr("Passed: all %n checks.", nullptr, table_->rowCount())
                         : tr("Not passed: %1 of %n checks.", nullptr, table_->rowCount()).arg(failed_));
}

void VerificationDialog::say(const QString& text) { sentence_->setText(text); }

void VerificationDialog::fail(const QString& problem) {
  setWaiting(false);
  sentence_->setText(problem);
}

}  // namespace abstand::ui
