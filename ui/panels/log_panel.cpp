// The messages of the window, to be read again.
#include "ui/panels/log_panel.hpp"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QToolButton>
#include <QVBoxLayout>

namespace abstand::ui {

LogPanel::LogPanel(const LogBook& book, QWidget* parent)
    : QWidget(parent),
      book_{book},
      lines_{new QPlainTextEdit(this)},
      only_problems_{new QCheckBox(tr("Only problems"), this)} {
  lines_->setReadOnly(true);
  lines_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  lines_->setMaximumBlockCount(static_cast<int>(LogBook::kMaxEntries));
  lines_->setLineWrapMode(QPlainTextEdit::NoWrap);
  lines_->setFrameShape(QFrame::NoFrame);
  lines_->setAccessibleName(tr("Messages of the window"));
  lines_->setPlaceholderText(tr("No messages"));
  auto* copy_all = new QToolButton(this);
  copy_all->setText(tr("Copy all"));
  copy_all->setToolTip(tr("Put all messages on the clipboard"));
  auto* head = new QHBoxLayout;
  head->setContentsMargins(8, 4, 8, 2);
  head->addWidget(only_problems_);
  head->addStretch();
  head->addWidget(copy_all);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(lines_, 1);
  connect(&book_, &LogBook::added, this, &LogPanel::add);
  connect(only_problems_, &QCheckBox::toggled, this, &LogPanel::showAll);
  connect(copy_all, &QToolButton::clicked, this, &LogPanel::copy);
  showAll();
}

void LogPanel::add(const LogEntry& entry) {
  if (only_problems_->isChecked() && entry.level != LogLevel::kProblem) return;
  lines_->appendPlainText(logLine(entry));
}

void LogPanel::showAll() {
  lines_->clear();
  for (const LogEntry& entry : book_.entries()) add(entry);
}

void LogPanel::copy() {
  QStringList all;
  for (const LogEntry& entry : book_.entries()) all << logLine(entry);
  QApplication::clipboard()->setText(all.join(QLatin1Char('\n')));
}

}  // namespace abstand::ui
