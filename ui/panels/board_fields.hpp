// Size and pose of a chessboard as numbers.
#pragma once

#include <QWidget>
#include <array>

#include "ui/model/calibration_request.hpp"

class QDoubleSpinBox;
class QSpinBox;

namespace abstand::ui {

/// Lengths and angles in the shown units. GUI thread only.
class BoardFields : public QWidget {
  Q_OBJECT

 public:
  explicit BoardFields(QWidget* parent);

  void show(const CalibrationRequest& request);
  /// Sets the board of the request.
  void fill(CalibrationRequest& request) const;

 private:
  static constexpr int kNumbers = 7;  ///< side of a square; x, y, z, roll, pitch, yaw
  double factor(int number) const;
  void applyUnits();

  QSpinBox *columns_, *rows_;
  std::array<QDoubleSpinBox*, kNumbers> numbers_{};
  std::array<double, kNumbers> values_{};  ///< m, rad
};

}  // namespace abstand::ui
