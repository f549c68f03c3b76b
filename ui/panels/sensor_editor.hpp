// Kind and pose of a planned depth camera, as a choice and numbers.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "ui/document/sensor_plan.hpp"
#include "ui/model/coverage_report.hpp"

class QComboBox;
class QDoubleSpinBox;

namespace abstand::ui {

/// In the shown units. GUI thread only.
class SensorEditor : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kNumbers = 6;  ///< x, y, z, azimuth, elevation, roll

  SensorEditor(const std::vector<SensorKind>& kinds, QWidget* parent);

  /// What the user is typing stays.
  void show(const SensorPlan& plan);
  QComboBox* kinds() const { return kinds_; }
  QDoubleSpinBox* box(int number) const { return boxes_[static_cast<std::size_t>(number)]; }

 Q_SIGNALS:
  /// By the user.
  void edited(const abstand::ui::SensorPlan& plan);

 private:
  void take(int number, double shown);
  void applyUnits();
  void showKind();
  double* numberOf(int number);

  SensorPlan plan_;
  const int named_;  ///< kinds that a plan may always choose
  QComboBox* kinds_;
  std::array<QDoubleSpinBox*, kNumbers> boxes_{};
};

}  // namespace abstand::ui
