#include "ui/panels/joint_row.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "ui/style/calm_inputs.hpp"
#include "ui/style/format.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {

constexpr double kFreeTurn = 4.0 * kPi, kFreeWay = 2.0;  // rad, m: range of a joint without limits
constexpr double kPerStep = 10.0;                        // steps of the slider per degree or millimetre

}  // namespace

JointRow::JointRow(const view::SceneOutline::JointInfo& joint, QWidget* parent)
    : QWidget(parent),
      lower_{std::max(joint.lower, joint.prismatic ? -kFreeWay : -kFreeTurn)},
      upper_{std::max(lower_, std::min(joint.upper, joint.prismatic ? kFreeWay : kFreeTurn))},
      prismatic_{joint.prismatic},
      slider_{new CalmSlider(Qt::Horizontal, this)},
      box_{new CalmSpinBox(this)} {
  const QString name = QString::fromStdString(joint.name);
  auto* label = new QLabel(name, this);
  label->setMinimumWidth(48);
  label->setToolTip(tr("Joint %1").arg(name));
  label->setBuddy(box_);
  slider_->setRange(toSlider(lower_), toSlider(upper_));
  slider_->setSingleStep(static_cast<int>(kPerStep));
  slider_->setPageStep(static_cast<int>(10.0 * kPerStep));
  slider_->setMinimumWidth(48);
  slider_->setMinimumHeight(24);
  slider_->setAccessibleName(tr("Joint %1, slider").arg(name));
  box_->setKeyboardTracking(false);
  box_->setFixedWidth(92);
  box_->setAccessibleName(tr("Value of joint %1").arg(name));
  const QString tip = tr("Poses the robot by hand: it no longer follows its motion");
  slider_->setToolTip(tip);
  box_->setToolTip(tip);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(label);
  layout->addWidget(slider_, 1);
  layout->addWidget(box_);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int steps) { take(steps / (kPerStep * sliderScale()), slider_); });
  connect(slider_, &QSlider::sliderReleased, this, &JointRow::released);
  connect(box_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double shown) { take(shown / factor(), box_); });
  connect(&Units::shown(), &Units::changed, this, &JointRow::applyUnit);
  applyUnit();
}

void JointRow::show(double value) {
  const bool is_typed = box_->hasFocus() && box_->findChild<QLineEdit*>()->isModified();
  if (slider_->isSliderDown() || is_typed) return;
  const QSignalBlocker no_slider(slider_);
  const QSignalBlocker no_box(box_);
  slider_->setValue(toSlider(value));
  box_->setValue(value * factor());
}

void JointRow::applyUnit() {
  const double value = box_->value() / factor_;
  factor_ = factor();
  const QSignalBlocker quiet(box_);
  box_->setDecimals(prismatic_ ? lengthDecimals(1) : angleDecimals(1));
  box_->setRange(lower_ * factor_, upper_ * factor_);
  box_->setSingleStep(factor_ / sliderScale());
  box_->setSuffix(prismatic_ ? QLatin1Char(' ') + lengthUnit() : angleUnit());
  box_->setValue(value * factor_);
}

double JointRow::factor() const { return prismatic_ ? lengthFactor() : angleFactor(); }

double JointRow::sliderScale() const { return prismatic_ ? 1e3 : 180.0 / kPi; }

int JointRow::toSlider(double value) const {
  return static_cast<int>(std::lround(value * sliderScale() * kPerStep));
}

void JointRow::take(double value, const QObject* from) {
  const QSignalBlocker no_slider(slider_);
  const QSignalBlocker no_box(box_);
  if (from != slider_) slider_->setValue(toSlider(value));
  if (from != box_) box_->setValue(value * factor());
  // The field rounds; the limits do not.
  Q_EMIT edited(std::clamp(value, lower_, upper_));
}

}  // namespace abstand::ui
