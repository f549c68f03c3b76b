#include "ui/panels/key_editor.hpp"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/actions.hpp"
#include "ui/style/kept_keys.hpp"

namespace abstand::ui {

namespace {

constexpr int kEditorWidth = 560, kEditorHeight = 520, kNameWidth = 330;  // px

QString nameOf(const QAction* action) { return action->text().remove(QLatin1Char('&')); }

QString keysText(const QAction* action) {
  QStringList keys;
  for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
  return keys.join(QStringLiteral(", "));
}

}  // namespace

KeyEditor::KeyEditor(const Actions& actions, QWidget* parent)
    : QDialog(parent),
      actions_(actions),
      field_{new QLineEdit(this)},
      list_{new QTreeWidget(this)},
      keys_{new QKeySequenceEdit(this)},
      said_{new QLabel(this)},
      assign_{new QPushButton(tr("&Assign"), this)},
      default_{new QPushButton(tr("&Default"), this)},
      all_{new QPushButton(tr("A&ll default keys"), this)} {
  setObjectName(QStringLiteral("key_editor"));
  setWindowTitle(tr("Change keys"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(kEditorWidth, kEditorHeight);
  build();
  connect(field_, &QLineEdit::textChanged, this, &KeyEditor::list);
  connect(list_, &QTreeWidget::currentItemChanged, this, &KeyEditor::showChosen);
  connect(keys_, &QKeySequenceEdit::keySequenceChanged, this, &KeyEditor::showClash);
  connect(assign_, &QPushButton::clicked, this, &KeyEditor::assign);
  connect(default_, &QPushButton::clicked, this, &KeyEditor::giveDefault);
  connect(all_, &QPushButton::clicked, this, &KeyEditor::giveAllDefaults);
  list(QString());
}

void KeyEditor::build() {
  field_->setPlaceholderText(tr("Words of a command"));
  field_->setAccessibleName(tr("Find a command"));
  field_->setClearButtonEnabled(true);
  list_->setHeaderLabels({tr("Command"), tr("Keys")});
  list_->setRootIsDecorated(false);
  list_->setAccessibleName(tr("Commands"));
  list_->header()->resizeSection(0, kNameWidth);
  keys_->setAccessibleName(tr("New key"));
  said_->setWordWrap(true);
  said_->setMinimumHeight(2 * said_->fontMetrics().lineSpacing());
  // Enter is a key like others while one is typed.
  for (QPushButton* button : {assign_, default_, all_}) button->setAutoDefault(false);
  auto* label = new QLabel(tr("&New key"), this);
  label->setBuddy(keys_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(keys_, 1);
  row->addWidget(assign_);
  row->addWidget(default_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->addButton(all_, QDialogButtonBox::ResetRole);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(field_);
  layout->addWidget(list_, 1);
  layout->addLayout(row);
  layout->addWidget(said_);
  layout->addWidget(buttons);
}

void KeyEditor::list(const QString& words) {
  list_->clear();
  const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (std::size_t i = 0; i < actions_.all().size(); ++i) {
    const Actions::Entry& entry = actions_.all()[i];
    if (!entry.action->isVisible()) continue;
    const QString name =
        tr("%1 › %2").arg(Actions::groupName(entry.group).remove(QLatin1Char('&')), nameOf(entry.action));
    const QString all =
        name + QLatin1Char(' ') + entry.action->statusTip() + QLatin1Char(' ') + keysText(entry.action);
    if (!std::all_of(wanted.begin(), wanted.end(),
                     [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); }))
      continue;
    auto* item = new QTreeWidgetItem(list_, {name, keysText(entry.action)});
    item->setData(0, Qt::UserRole, static_cast<int>(i));
    item->setToolTip(0, entry.action->statusTip());
  }
  list_->setCurrentItem(list_->topLevelItem(0));
  showKeys();
  showChosen();
}

QAction* KeyEditor::chosen() const {
  const QTreeWidgetItem* item = list_->currentItem();
  return item ? actions_.all()[item->data(0, Qt::UserRole).toUInt()].action : nullptr;
}

void KeyEditor::showChosen() {
  const QAction* action = chosen();
  keys_->setEnabled(action);
  keys_->setKeySequence(action ? action->shortcut() : QKeySequence());
  showClash();
}

void KeyEditor::showClash() {
  const QAction* action = chosen();
  const QKeySequence key = keys_->keySequence();
  const QAction* owner = action && !key.isEmpty() ? actions_.ownerOf(key, action) : nullptr;
  said_->setText(owner
                     ? tr("%1 is taken from “%2”.").arg(key.toString(QKeySequence::NativeText), nameOf(owner))
                     : QString());
  assign_->setEnabled(action && !key.isEmpty() && !action->shortcuts().contains(key));
  default_->setEnabled(action &&
                       action->shortcuts() !=
                           actions_.all()[list_->currentItem()->data(0, Qt::UserRole).toUInt()].default_keys);
}

void KeyEditor::assign() {
  if (QAction* action = chosen()) give(action, {keys_->keySequence()});
}

void KeyEditor::giveDefault() {
  if (QAction* action = chosen())
    give(action, actions_.all()[list_->currentItem()->data(0, Qt::UserRole).toUInt()].default_keys);
}

void KeyEditor::giveAllDefaults() {
  resetKeys(actions_);
  saveKeys(actions_);
  showKeys();
  showChosen();
}

void KeyEditor::give(QAction* action, const QList<QKeySequence>& keys) {
  for (const QKeySequence& key : keys)
    while (QAction* owner = actions_.ownerOf(key, action)) {
      QList<QKeySequence> left;
      for (const QKeySequence& own : owner->shortcuts())
        if (own.matches(key) == QKeySequence::NoMatch && key.matches(own) == QKeySequence::NoMatch)
          left << own;
      Actions::setKeys(owner, left);
    }
  Actions::setKeys(action, keys);
  saveKeys(actions_);
  showKeys();
  showChosen();
}

void KeyEditor::showKeys() {
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    QTreeWidgetItem* item = list_->topLevelItem(row);
    const Actions::Entry& entry = actions_.all()[item->data(0, Qt::UserRole).toUInt()];
    item->setText(1, keysText(entry.action));
    QFont font = list_->font();
    font.setBold(entry.action->shortcuts() != entry.default_keys);
    item->setFont(1, font);
  }
}

}  // namespace abstand::ui
