#include "ui/panels/sensor_editor.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include "ui/panels/lens_kind.hpp"
#include "ui/style/calm_inputs.hpp"
#include "ui/style/format.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {

constexpr double kFarSensor = 100.0;                            // m, from the origin
constexpr double kSensorStep = 0.05, kSensorTurn = kPi / 36.0;  // m, rad, of the arrows beside a number
constexpr int kFirstAngle = 3, kElevation = 4;

double sensorFactor(int number) { return number < kFirstAngle ? lengthFactor() : angleFactor(); }

}  // namespace

SensorEditor::SensorEditor(const std::vector<SensorKind>& kinds, QWidget* parent)
    : QWidget(parent), named_{static_cast<int>(kinds.size())}, kinds_{new QComboBox(this)} {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  for (const SensorKind& kind : kinds) kinds_->addItem(kind.title, kind.name);
  kinds_->setObjectName(QStringLiteral("sensor_kind"));
  auto* kind_label = new QLabel(tr("&Sensor"), this);
  kind_label->setBuddy(kinds_);
  grid->addWidget(kind_label, 0, 0);
  grid->addWidget(kinds_, 0, 1, 1, 5);
  const QString names[] = {tr("&x"), tr("&y"), tr("&z"), tr("&Azimuth"), tr("&Elevation"), tr("&Roll")};
  const QString tips[] = {tr("Place of the sensor in the world"),
                          tr("Place of the sensor in the world"),
                          tr("Place of the sensor in the world"),
                          tr("Direction in which it looks, about the vertical; 0: along x"),
                          tr("Direction in which it looks, above the horizon; below 0: down"),
                          tr("Turn about that direction; 0: level")};
  for (int number = 0; number < kNumbers; ++number) {
    auto* box = new CalmSpinBox(this);
    boxes_[static_cast<std::size_t>(number)] = box;
    auto* label = new QLabel(names[number], this);
    label->setBuddy(box);
    box->setObjectName(QStringLiteral("sensor_%1").arg(number));
    box->setAccessibleName(QString(names[number]).remove(QLatin1Char('&')));
    box->setToolTip(tips[number]);
    box->setKeyboardTracking(false);
    const int row = 1 + number / 3, column = 2 * (number % 3);
    grid->addWidget(label, row, column);
    grid->addWidget(box, row, column + 1);
    grid->setColumnStretch(column + 1, 1);
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, number](double shown) { take(number, shown); });
  }
  connect(kinds_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    plan_.sensor = kinds_->currentData().toString();
    Q_EMIT edited(plan_);
  });
  connect(&Units::shown(), &Units::changed, this, &SensorEditor::applyUnits);
  applyUnits();
}

double* SensorEditor::numberOf(int number) {
  double* const angles[] = {&plan_.azimuth, &plan_.elevation, &plan_.roll};
  return number < kFirstAngle ? &plan_.xyz[number] : angles[number - kFirstAngle];
}

void SensorEditor::applyUnits() {
  for (int number = 0; number < kNumbers; ++number) {
    const bool angle = number >= kFirstAngle;
    const double most = (number == kElevation ? 0.5 * kPi : angle ? kPi : kFarSensor) * sensorFactor(number);
    QDoubleSpinBox* box = this->box(number);
    const QSignalBlocker quiet(box);
    box->setDecimals(angle ? angleDecimals(1) : lengthDecimals(0));
    box->setRange(-most, most);
    box->setWrapping(angle && number != kElevation);
    box->setSingleStep((angle ? kSensorTurn : kSensorStep) * sensorFactor(number));
    box->setSuffix(angle ? angleUnit() : QLatin1Char(' ') + lengthUnit());
    box->setValue(*numberOf(number) * sensorFactor(number));
  }
}

/// The lens of a camera file is a choice after the others, as long as the plan has one.
void SensorEditor::showKind() {
  while (kinds_->count() > named_) kinds_->removeItem(named_);
  if (plan_.lens) kinds_->addItem(kindOf(*plan_.lens, kFileSensor).title, kFileSensor);
  kinds_->setCurrentIndex(kinds_->findData(plan_.sensor));
}

void SensorEditor::show(const SensorPlan& plan) {
  plan_ = plan;
  showKind();
  for (int number = 0; number < kNumbers; ++number) {
    QDoubleSpinBox* box = this->box(number);
    if (box->hasFocus() && box->findChild<QLineEdit*>()->isModified()) continue;
    const QSignalBlocker quiet(box);
    box->setValue(*numberOf(number) * sensorFactor(number));
  }
}

/// The other numbers stay as exact as they are.
void SensorEditor::take(int number, double shown) {
  *numberOf(number) = shown / sensorFactor(number);
  Q_EMIT edited(plan_);
}

}  // namespace abstand::ui
