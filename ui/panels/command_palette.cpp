#include "ui/panels/command_palette.hpp"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

constexpr int kWidth = 520, kHeight = 420;  // px

QString withoutMnemonic(QString text) { return text.remove(QLatin1Char('&')); }

}  // namespace

CommandPalette::CommandPalette(const Actions& actions, QWidget* parent)
    : QDialog(parent), field_{new QLineEdit(this)}, list_{new QListWidget(this)} {
  setObjectName(QStringLiteral("palette"));
  setWindowTitle(tr("Find a command"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(kWidth, kHeight);
  for (const auto& entry : actions.all()) {
    if (!entry.action->isVisible()) continue;
    const QString name = tr("%1 › %2").arg(withoutMnemonic(Actions::groupName(entry.group)),
                                           withoutMnemonic(entry.action->text()));
    const QString key = entry.action->shortcut().toString(QKeySequence::NativeText);
    commands_.push_back({entry.action, key.isEmpty() ? name : tr("%1   %2").arg(name, key),
                         name + QLatin1Char(' ') + entry.action->statusTip()});
  }
  field_->setPlaceholderText(tr("Words of a command"));
  field_->setAccessibleName(tr("Find a command"));
  field_->setClearButtonEnabled(true);
  field_->installEventFilter(this);
  list_->setAccessibleName(tr("Commands"));
  list_->setFocusPolicy(Qt::NoFocus);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(field_);
  layout->addWidget(list_, 1);
  connect(field_, &QLineEdit::textChanged, this, &CommandPalette::listThoseWith);
  connect(field_, &QLineEdit::returnPressed, this, &CommandPalette::run);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
  listThoseWith(QString());
}

void CommandPalette::listThoseWith(const QString& words) {
  list_->clear();
  const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const Command& command = commands_[i];
    const bool fits = std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
      return command.words.contains(word, Qt::CaseInsensitive);
    });
    if (!fits) continue;
    auto* item = new QListWidgetItem(command.text, list_);
    item->setData(Qt::UserRole, static_cast<int>(i));
    item->setToolTip(command.action->statusTip());
    if (!command.action->isEnabled()) item->setFlags(Qt::NoItemFlags);
  }
  for (int row = 0; row < list_->count() && !list_->currentItem(); ++row)
    if (list_->item(row)->flags() & Qt::ItemIsEnabled) list_->setCurrentRow(row);
}

void CommandPalette::run() {
  const QListWidgetItem* item = list_->currentItem();
  if (!item) return;
  const QPointer<QAction> action = commands_[item->data(Qt::UserRole).toUInt()].action;
  close();
  // After this dialog has gone: the command may ask something itself.
  QTimer::singleShot(0, parentWidget(), [action] {
    if (action && action->isEnabled()) action->trigger();
  });
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
      QApplication::sendEvent(list_, event);
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace abstand::ui
