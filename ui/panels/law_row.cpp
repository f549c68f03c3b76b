#include "ui/panels/law_row.hpp"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include "ui/model/law_text.hpp"
#include "ui/panels/back_button.hpp"
#include "ui/style/elided_label.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr int kLawNameWidth = 100, kUnitWidth = 52, kIndent = 10;  // px
constexpr int kPageSteps = 10;

}  // namespace

LawRow::LawRow(const control::LawNumber& number, int joints, QWidget* parent)
    : QWidget(parent),
      number_{number},
      joints_{number.each_joint ? joints : 1},
      name_{new QLabel(numberName(number.key), this)},
      field_{new QLineEdit(this)},
      back_{nullptr},
      refusal_{new QLabel(this)} {
  field_->setObjectName(QString::fromStdString(number.key));
  field_->setMinimumWidth(56);
  field_->installEventFilter(this);
  name_->setFixedWidth(kLawNameWidth);
  name_->setWordWrap(true);
  name_->setBuddy(field_);
  auto* unit = new ElidedLabel(unitText(number.rule.unit), this);
  unit->setFixedWidth(kUnitWidth);
  unit->setToolTip(unit->text());
  back_ = new BackButton(field_, name_->text(), this);
  refusal_->setObjectName(QStringLiteral("refusal ") + field_->objectName());
  refusal_->setWordWrap(true);
  QPalette alarm = refusal_->palette();
  alarm.setColor(QPalette::WindowText, QColor(kVermillion));
  refusal_->setPalette(alarm);
  refusal_->hide();
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(kIndent, 0, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(0);
  grid->addWidget(name_, 0, 0);
  grid->addWidget(field_, 0, 1);
  grid->addWidget(unit, 0, 2);
  grid->addWidget(back_, 0, 3);
  grid->addWidget(refusal_, 1, 0, 1, 4);
  grid->setColumnStretch(1, 1);
  connect(field_, &QLineEdit::editingFinished, this, [this] {
    take();
    Q_EMIT left();
  });
  connect(back_, &QToolButton::clicked, this, &LawRow::backWanted);
  show(number, true);
}

void LawRow::show(const control::LawNumber& number, bool overwrite) {
  const bool other = number.value != number_.value;
  number_ = number;
  const bool differs = number.value != number.scene;
  if (overwrite || other || !field_->isModified()) {
    field_->setText(numbersText(number.value));
    field_->setCursorPosition(0);
    refusal_->hide();
  }
  QFont font = name_->font();
  font.setBold(differs);
  name_->setFont(font);
  const QString scene = numbersText(number.scene);
  back_->show(differs, scene);
  const QString unit = unitText(number.rule.unit);
  const QString tip =
      QStringList{numberMeaning(number.key), unit.isEmpty() ? tr("No unit.") : tr("Unit: %1.").arg(unit),
                  ruleText(number.rule, joints_),
                  tr("In scene files: %1; in this one: %2.").arg(QString::fromStdString(number.key), scene)}
          .join(QLatin1Char('\n'));
  for (QWidget* widget : {static_cast<QWidget*>(name_), static_cast<QWidget*>(field_)})
    widget->setToolTip(tip);
  field_->setAccessibleName(name_->text());
  field_->setAccessibleDescription(tip);
}

void LawRow::refuse(const QString& why) {
  refusal_->setText(why);
  refusal_->show();
  field_->setModified(true);
}

QString LawRow::refusal() const { return refusal_->isHidden() ? QString() : refusal_->text(); }

void LawRow::take() {
  if (!field_->isModified()) return;
  const config::JointNumbers numbers = numbersFromText(field_->text());
  const bool counted = numbers.size() == 1 || static_cast<int>(numbers.size()) == joints_;
  for (const double number : numbers)
    if (!number_.rule.allows(number)) return refuse(ruleText(number_.rule, joints_));
  if (numbers.empty() || !counted) return refuse(ruleText(number_.rule, joints_));
  field_->setModified(false);
  refusal_->hide();
  if (numbers == number_.value)
    show(number_, true);
  else
    Q_EMIT edited(numbers);
}

void LawRow::step(int steps) {
  take();
  if (number_.value.size() != 1 || !refusal().isEmpty()) return;
  const double next = steppedNumber(number_.value.front(), steps, number_.rule);
  if (next != number_.value.front()) Q_EMIT edited({next});
}

bool LawRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched != field_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Up:
      step(1);
      return true;
    case Qt::Key_Down:
      step(-1);
      return true;
    case Qt::Key_PageUp:
      step(kPageSteps);
      return true;
    case Qt::Key_PageDown:
      step(-kPageSteps);
      return true;
    case Qt::Key_Escape:
      show(number_, true);
      return true;
    default:
      return QWidget::eventFilter(watched, event);
  }
}

}  // namespace abstand::ui
