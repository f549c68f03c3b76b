// Keys belong to the widget that has the focus before they are shortcuts.
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace abstand::ui {

/// Filters the application's events as long as it lives: arrows, Home and End move a focused slider and walk
/// through a focused tree or table, Space ticks in a tree and presses a button that Tab has reached. GUI
/// thread only.
class FocusKeys : public QObject {
  Q_OBJECT

 public:
  explicit FocusKeys(QObject* parent);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace abstand::ui
