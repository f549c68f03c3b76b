#include "ui/panels/class_margin_row.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>

#include "ui/panels/margin_row.hpp"

namespace abstand::ui {

ClassMarginRow::ClassMarginRow(const QString& name, QWidget* parent)
    : QWidget(parent), tick_{new QCheckBox(this)}, row_{new MarginRow(name, false, this)} {
  tick_->setAccessibleName(tr("One margin for all pairs %1").arg(name));
  tick_->setToolTip(tr("One margin for all pairs %1, instead of the sums of two bodies' margins").arg(name));
  row_->layout()->setContentsMargins(0, 0, 0, 0);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(tick_);
  layout->addWidget(row_, 1);
  show({}, false);
  connect(tick_, &QCheckBox::clicked, this, [this](bool on) {
    tick_->setChecked(!on);  // until the document says so
    Q_EMIT tickWanted(on);
  });
  connect(row_, &MarginRow::edited, this, &ClassMarginRow::edited);
  connect(row_, &MarginRow::released, this, &ClassMarginRow::released);
  connect(row_, &MarginRow::lockWanted, this, &ClassMarginRow::lockWanted);
}

void ClassMarginRow::show(const std::optional<double>& metres, bool locked) {
  tick_->setChecked(metres.has_value());
  tick_->setEnabled(!locked);
  row_->setEnabled(metres.has_value());
  row_->setLocked(locked);
  // A row that shows its margin already may be in the middle of an edit.
  if (metres && row_->metres() != *metres) row_->show(*metres);
}

void ClassMarginRow::showSum(double metres) { row_->show(metres); }

int ClassMarginRow::nameWidth() const { return row_->findChild<QLabel*>()->sizeHint().width(); }

void ClassMarginRow::setNameWidth(int width) { row_->findChild<QLabel*>()->setFixedWidth(width); }

bool ClassMarginRow::isTicked() const { return tick_->isChecked(); }

bool ClassMarginRow::isDragged() const { return row_->isDragged(); }

}  // namespace abstand::ui
