// Where a person, a robot or an object of the room stands, as numbers.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "ui/document/placement.hpp"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace abstand::ui {

/// Six numbers in the shown units, and a button that gives the place back to the scene. A person only turns
/// about z. GUI thread only.
class PlacementEditor : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { kNone, kThing, kRobot, kPerson };
  static constexpr int kAxes = 6;  ///< x, y, z, roll, pitch, yaw

  explicit PlacementEditor(QWidget* parent = nullptr);

  /// Whose place it is. kNone: nobody's.
  void open(Kind kind, const QString& name);
  /// `placed`: it is not where the scene says. What the user is typing stays.
  void show(const Placement& placement, bool placed);
  Kind kind() const { return kind_; }
  const QString& name() const { return name_; }
  QDoubleSpinBox* box(int axis) const { return boxes_[static_cast<std::size_t>(axis)]; }
  QPushButton* resetButton() const { return reset_; }

 Q_SIGNALS:
  /// By the user. `axis`: the number that was changed.
  void edited(const abstand::ui::Placement& placement, int axis);
  void resetWanted();

 private:
  void take(int axis, double shown);
  void applyUnits();
  double factor(int axis) const;

  Kind kind_{Kind::kNone};
  QString name_;
  Placement placement_;
  QLabel* title_;
  std::array<QDoubleSpinBox*, kAxes> boxes_{};
  std::array<QLabel*, kAxes> labels_{};
  QPushButton* reset_;
};

}  // namespace abstand::ui
