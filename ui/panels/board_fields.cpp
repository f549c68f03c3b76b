#include "ui/panels/board_fields.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include "ui/style/format.hpp"
#include "ui/style/number_box.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {

constexpr int kMinSquares = 4, kMaxSquares = 40;                // as `abstand calibrate`
constexpr double kSmallestSquare = 1e-3, kLargestSquare = 1.0;  // m
constexpr double kFarBoard = 100.0;                             // m
constexpr int kFirstBoardAngle = 4;

}  // namespace

BoardFields::BoardFields(QWidget* parent)
    : QWidget(parent), columns_{new QSpinBox(this)}, rows_{new QSpinBox(this)} {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](QWidget* field, const QString& name, const char* object, int row, int column) {
    auto* label = new QLabel(name, this);
    label->setBuddy(field);
    field->setAccessibleName(name);
    field->setObjectName(QString::fromLatin1(object));
    grid->addWidget(label, row, 2 * column);
    grid->addWidget(field, row, 2 * column + 1);
    grid->setColumnStretch(2 * column + 1, 1);
  };
  for (QSpinBox* squares : {columns_, rows_}) squares->setRange(kMinSquares, kMaxSquares);
  add(columns_, tr("Squares along x"), "board_columns", 0, 0);
  add(rows_, tr("Squares along y"), "board_rows", 0, 1);
  const QString names[] = {
      tr("Side of a square"), tr("x"), tr("y"), tr("z"), tr("roll"), tr("pitch"), tr("yaw")};
  const char* const objects[] = {"board_square", "board_x",     "board_y",  "board_z",
                                 "board_roll",   "board_pitch", "board_yaw"};
  for (int number = 0; number < kNumbers; ++number) {
    const auto n = static_cast<std::size_t>(number);
    auto* box = new NumberBox(this);
    numbers_[n] = box;
    add(box, names[number], objects[number], number == 0 ? 0 : 1 + (number - 1) / 3,
        number == 0 ? 2 : (number - 1) % 3);
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, number, n](double shown) { values_[n] = shown / factor(number); });
  }
  connect(&Units::shown(), &Units::changed, this, &BoardFields::applyUnits);
  show({});
}

double BoardFields::factor(int number) const {
  return number < kFirstBoardAngle ? lengthFactor() : angleFactor();
}

void BoardFields::applyUnits() {
  for (int number = 0; number < kNumbers; ++number) {
    QDoubleSpinBox* box = numbers_[static_cast<std::size_t>(number)];
    const QSignalBlocker quiet(box);
    const bool angle = number >= kFirstBoardAngle;
    const double smallest = number == 0 ? kSmallestSquare : angle ? -2.0 * kPi : -kFarBoard;
    const double largest = number == 0 ? kLargestSquare : -smallest;
    box->setDecimals(angle ? angleDecimals(1) : lengthDecimals(1));
    box->setRange(smallest * factor(number), largest * factor(number));
    box->setSuffix(angle ? angleUnit() : QLatin1Char(' ') + lengthUnit());
    box->setValue(values_[static_cast<std::size_t>(number)] * factor(number));
  }
}

void BoardFields::show(const CalibrationRequest& request) {
  columns_->setValue(request.columns);
  rows_->setValue(request.rows);
  values_[0] = request.square;
  for (int i = 0; i < 3; ++i) {
    values_[static_cast<std::size_t>(1 + i)] = request.board_xyz[i];
    values_[static_cast<std::size_t>(kFirstBoardAngle + i)] = request.board_rpy[i];
  }
  applyUnits();
}

void BoardFields::fill(CalibrationRequest& request) const {
  request.columns = columns_->value();
  request.rows = rows_->value();
  request.square = values_[0];
  for (int i = 0; i < 3; ++i) {
    request.board_xyz[i] = values_[static_cast<std::size_t>(1 + i)];
    request.board_rpy[i] = values_[static_cast<std::size_t>(kFirstBoardAngle + i)];
  }
}

}  // namespace abstand::ui
