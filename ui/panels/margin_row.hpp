// Slider and spin box for one length.
#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace abstand::ui {

/// Slider and spin box show the same value. GUI thread only.
class MarginRow : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kSliderLimit = 0.3;  ///< m, the slider's right end
  static constexpr double kLimit = 2.0;        ///< m, the spin box's

  MarginRow(const QString& name, bool heading, QWidget* parent = nullptr);

  double metres() const { return metres_; }
  /// The user holds the slider.
  bool isDragged() const;
  /// Without a signal.
  void show(double metres);
  /// A locked row cannot be moved. Without a signal.
  void setLocked(bool locked);
  bool locked() const { return locked_; }
  /// Of the selection.
  void setMarked(bool marked);
  bool marked() const { return autoFillBackground(); }

 Q_SIGNALS:
  /// The user moved it.
  void edited(double metres);
  /// The user let go of the slider.
  void released();
  /// The user clicked the lock.
  void lockWanted(bool locked);

 private:
  void applyUnit();
  void take(double metres, const QObject* from);

  QSlider* slider_;
  QDoubleSpinBox* box_;
  QToolButton* lock_;
  double metres_{0.0};
  bool locked_{false};
};

}  // namespace abstand::ui
