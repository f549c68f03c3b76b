#include "ui/panels/placement_editor.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/style/calm_inputs.hpp"
#include "ui/style/format.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {

constexpr double kFarPlace = 100.0;  // m, from the origin
constexpr double kPlaceStep = 0.01;  // m, of the arrows beside a number
constexpr double kTurnStep = kPi / 36.0;
constexpr int kFirstTurn = 3, kYaw = 5;
constexpr const char* kAxisNames[] = {"x", "y", "z", "roll", "pitch", "yaw"};

}  // namespace

PlacementEditor::PlacementEditor(QWidget* parent)
    : QWidget(parent), title_{new QLabel(this)}, reset_{new QPushButton(tr("As in the scene"), this)} {
  setObjectName(QStringLiteral("placement"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 4, 8, 4);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(2);
  title_->setWordWrap(true);
  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(reset_);
  grid->addLayout(head, 0, 0, 1, 4);
  const QString names[] = {tr("x"), tr("y"), tr("z"), tr("roll"), tr("pitch"), tr("yaw")};
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    auto* box = new CalmSpinBox(this);
    boxes_[a] = box;
    labels_[a] = new QLabel(names[axis], this);
    labels_[a]->setBuddy(box);
    box->setObjectName(QStringLiteral("place_") + QString::fromLatin1(kAxisNames[axis]));
    box->setAccessibleName(axis < kFirstTurn ? tr("Place, %1").arg(names[axis])
                                             : tr("Turn, %1").arg(names[axis]));
    box->setKeyboardTracking(false);
    box->setMinimumWidth(92);
    const int row = 1 + axis % 3, column = 2 * (axis / 3);
    grid->addWidget(labels_[a], row, column);
    grid->addWidget(box, row, column + 1);
    grid->setColumnStretch(column + 1, 1);
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, axis](double shown) { take(axis, shown); });
  }
  reset_->setObjectName(QStringLiteral("place_as_in_scene"));
  reset_->setFocusPolicy(Qt::TabFocus);
  connect(reset_, &QPushButton::clicked, this, &PlacementEditor::resetWanted);
  connect(&Units::shown(), &Units::changed, this, &PlacementEditor::applyUnits);
  applyUnits();
  open(Kind::kNone, QString());
}

double PlacementEditor::factor(int axis) const { return axis < kFirstTurn ? lengthFactor() : angleFactor(); }

void PlacementEditor::applyUnits() {
  for (int axis = 0; axis < kAxes; ++axis) {
    const bool turn = axis >= kFirstTurn;
    QDoubleSpinBox* box = this->box(axis);
    const QSignalBlocker quiet(box);
    box->setDecimals(turn ? angleDecimals(1) : lengthDecimals(0));
    box->setRange((turn ? -2.0 * kPi : -kFarPlace) * factor(axis),
                  (turn ? 2.0 * kPi : kFarPlace) * factor(axis));
    box->setSingleStep((turn ? kTurnStep : kPlaceStep) * factor(axis));
    box->setSuffix(turn ? angleUnit() : QLatin1Char(' ') + lengthUnit());
    const Vector3d& numbers = turn ? placement_.rpy : placement_.xyz;
    box->setValue(numbers[axis % 3] * factor(axis));
  }
}

void PlacementEditor::open(Kind kind, const QString& name) {
  kind_ = kind;
  name_ = name;
  setVisible(kind != Kind::kNone);
  title_->setText(tr("Place of %1").arg(name));
  title_->setToolTip(kind == Kind::kPerson  ? tr("Where the origin of the recording is in the world")
                     : kind == Kind::kRobot ? tr("Where the base of the robot is in the world")
                                            : tr("Where the origin of the body is in the world"));
  for (int axis = kFirstTurn; axis < kYaw; ++axis) {
    labels_[static_cast<std::size_t>(axis)]->setVisible(kind != Kind::kPerson);
    box(axis)->setVisible(kind != Kind::kPerson);
  }
}

void PlacementEditor::show(const Placement& placement, bool placed) {
  placement_ = placement;
  reset_->setEnabled(placed);
  for (int axis = 0; axis < kAxes; ++axis) {
    QDoubleSpinBox* box = this->box(axis);
    if (box->hasFocus() && box->findChild<QLineEdit*>()->isModified()) continue;
    const QSignalBlocker quiet(box);
    const Vector3d& numbers = axis < kFirstTurn ? placement.xyz : placement.rpy;
    box->setValue(numbers[axis % 3] * factor(axis));
  }
}

/// The other numbers stay as exact as they are.
void PlacementEditor::take(int axis, double shown) {
  Vector3d& numbers = axis < kFirstTurn ? placement_.xyz : placement_.rpy;
  numbers[axis % 3] = shown / factor(axis);
  Q_EMIT edited(placement_, axis);
}

}  // namespace abstand::ui
