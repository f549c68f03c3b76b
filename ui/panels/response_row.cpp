#include "ui/panels/response_row.hpp"

#include <QHBoxLayout>
#include <QLabel>

#include "ui/model/stop_text.hpp"
#include "ui/panels/back_button.hpp"
#include "ui/style/calm_inputs.hpp"

namespace abstand::ui {

namespace {

constexpr int kReasonWidth = 96, kReasonIndent = 2;  // px

}  // namespace

ResponseRow::ResponseRow(const control::StopChoice& choice, QWidget* parent)
    : QWidget(parent),
      choice_{choice},
      name_{new QLabel(this)},
      box_{new CalmComboBox(this)},
      back_{nullptr} {
  QString reason = reasonText(choice.reason);
  reason[0] = reason[0].toUpper();
  const QString key = QString::fromLatin1(safety::reasonKey(choice.reason).data());
  name_->setText(reason);
  name_->setFixedWidth(kReasonWidth);
  name_->setWordWrap(true);
  name_->setBuddy(box_);
  box_->setObjectName(QStringLiteral("response ") + key);
  box_->setAccessibleName(tr("Response to: %1").arg(reason));
  box_->setMinimumContentsLength(4);
  box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (std::size_t i = 0; i < safety::kStopResponses; ++i)
    box_->addItem(responseText(static_cast<safety::StopResponse>(i)));
  back_ = new BackButton(box_, reason, this);
  const QString tip =
      QStringList{reasonMeaning(choice.reason),
                  tr("In scene files: stop.on.%1; in this one: %2.").arg(key, responseText(choice.scene))}
          .join(QLatin1Char('\n'));
  for (QWidget* widget : {static_cast<QWidget*>(name_), static_cast<QWidget*>(box_)}) widget->setToolTip(tip);
  box_->setAccessibleDescription(tip);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kReasonIndent, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(name_);
  row->addWidget(box_, 1);
  row->addWidget(back_);
  connect(box_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { Q_EMIT edited(static_cast<safety::StopResponse>(index)); });
  connect(back_, &QToolButton::clicked, this, [this] { Q_EMIT edited(choice_.scene); });
  show(choice);
}

void ResponseRow::show(const control::StopChoice& choice) {
  choice_ = choice;
  box_->setCurrentIndex(static_cast<int>(choice.value));
  const bool differs = choice.value != choice.scene;
  QFont font = name_->font();
  font.setBold(differs);
  name_->setFont(font);
  back_->show(differs, responseText(choice.scene));
}

}  // namespace abstand::ui
