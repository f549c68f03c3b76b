// Slider and spin box for one length.
#include "ui/panels/margin_row.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "ui/style/calm_inputs.hpp"
#include "ui/style/format.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {

constexpr double kStep = 1e-3;  // m

int toSlider(double metres) { return static_cast<int>(std::lround(metres * 1e3)); }

}  // namespace

MarginRow::MarginRow(const QString& name, bool heading, QWidget* parent)
    : QWidget(parent),
      slider_{new CalmSlider(Qt::Horizontal, this)},
      box_{new CalmSpinBox(this)},
      lock_{new QToolButton(this)} {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(heading ? 0 : 10, 0, 0, 0);
  layout->setSpacing(4);
  auto* label = new QLabel(name, this);
  label->setMinimumWidth(heading ? 100 : 90);
  label->setToolTip(name);
  label->setBuddy(box_);
  if (heading) {
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
  }
  slider_->setRange(0, toSlider(kSliderLimit));
  slider_->setSingleStep(1);
  slider_->setPageStep(10);
  slider_->setMinimumWidth(48);
  slider_->setMinimumHeight(24);
  slider_->setAccessibleName(tr("Margin of %1, slider").arg(name));
  box_->setKeyboardTracking(false);
  box_->setFixedWidth(86);
  box_->setAccessibleName(tr("Margin of %1").arg(name));
  const QString tip = tr("Safety margin around %1").arg(name);
  slider_->setToolTip(tip);
  box_->setToolTip(tip);
  layout->addWidget(label);
  layout->addWidget(slider_, 1);
  layout->addWidget(box_);
  lock_->setObjectName(QStringLiteral("lock"));
  lock_->setIcon(icon(Glyph::kUnlocked));
  lock_->setCheckable(true);
  lock_->setAutoRaise(true);
  lock_->setFixedSize(20, 24);
  lock_->setIconSize(QSize(14, 14));
  lock_->setFocusPolicy(Qt::TabFocus);
  lock_->setAccessibleName(tr("Lock the margin of %1").arg(name));
  lock_->setToolTip(tr("Lock: sliders, presets, pasted and proposed margins leave %1 alone").arg(name));
  layout->addWidget(lock_);

  connect(slider_, &QSlider::valueChanged, this, [this](int mm) { take(mm * 1e-3, slider_); });
  connect(slider_, &QSlider::sliderReleased, this, &MarginRow::released);
  connect(box_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double shown) { take(shown / lengthFactor(), box_); });
  connect(&Units::shown(), &Units::changed, this, &MarginRow::applyUnit);
  applyUnit();
  connect(lock_, &QToolButton::clicked, this, [this](bool locked) {
    setLocked(locked_);  // until the document says so
    Q_EMIT lockWanted(locked);
  });
}

void MarginRow::applyUnit() {
  const QSignalBlocker quiet(box_);
  box_->setDecimals(lengthDecimals(0));
  box_->setRange(0.0, kLimit * lengthFactor());
  box_->setSingleStep(kStep * lengthFactor());
  box_->setSuffix(QLatin1Char(' ') + lengthUnit());
  box_->setValue(metres_ * lengthFactor());
}

void MarginRow::setLocked(bool locked) {
  locked_ = locked;
  lock_->setChecked(locked);
  lock_->setIcon(icon(locked ? Glyph::kLocked : Glyph::kUnlocked));
  slider_->setEnabled(!locked);
  box_->setEnabled(!locked);
}

void MarginRow::setMarked(bool marked) {
  if (marked == autoFillBackground()) return;
  setBackgroundRole(marked ? QPalette::Midlight : QPalette::Window);
  setAutoFillBackground(marked);
}

bool MarginRow::isDragged() const { return slider_->isSliderDown(); }

void MarginRow::show(double metres) {
  metres_ = metres;
  const QSignalBlocker no_slider(slider_);
  const QSignalBlocker no_box(box_);
  slider_->setValue(toSlider(metres));
  box_->setValue(metres * lengthFactor());
}

void MarginRow::take(double metres, const QObject* from) {
  metres_ = metres;
  const QSignalBlocker no_slider(slider_);
  const QSignalBlocker no_box(box_);
  if (from != slider_) slider_->setValue(toSlider(metres));
  if (from != box_) box_->setValue(metres * lengthFactor());
  Q_EMIT edited(metres);
}

}  // namespace abstand::ui
