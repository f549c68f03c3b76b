// Slider and number field for one joint of a robot.
#pragma once

#include <QWidget>

#include "core/view/snapshot.hpp"

class QDoubleSpinBox;
class QSlider;

namespace abstand::ui {

/// Within the limits of the joint, or two turns (two metres) where it has none. Shows the unit that
/// was chosen; takes and gives rad or m. GUI thread only.
class JointRow : public QWidget {
  Q_OBJECT

 public:
  explicit JointRow(const view::SceneOutline::JointInfo& joint, QWidget* parent = nullptr);

  /// Without a signal. What the user is changing just now stays.
  void show(double value);

 Q_SIGNALS:
  /// By the user, within the limits.
  void edited(double value);
  /// The slider was let go.
  void released();

 private:
  void applyUnit();
  double factor() const;       // shown unit per rad or m
  double sliderScale() const;  // degrees or millimetres per rad or m
  int toSlider(double value) const;
  void take(double value, const QObject* from);

  double lower_, upper_;  // rad or m
  bool prismatic_;
  double factor_{1.0};  // of what the field shows
  QSlider* slider_;
  QDoubleSpinBox* box_;
};

}  // namespace abstand::ui
