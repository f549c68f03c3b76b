// Sliders, number fields and choices for a scroll area: the wheel scrolls past them and does not change their
// values.
#pragma once

#include <QComboBox>
#include <QSlider>
#include <QWheelEvent>

#include "ui/style/number_box.hpp"

namespace abstand::ui {

class CalmSlider : public QSlider {
 public:
  using QSlider::QSlider;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

class CalmComboBox : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

/// Follows the wheel while it has the focus.
class CalmSpinBox : public NumberBox {
 public:
  using NumberBox::NumberBox;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus())
      NumberBox::wheelEvent(event);
    else
      event->ignore();
  }
};

}  // namespace abstand::ui
