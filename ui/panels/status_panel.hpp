// The status bar: what this is not, nearest pair, speed of the computation.
#pragma once

#include <QObject>

#include "core/scene/snapshot.hpp"

class QLabel;
class QStatusBar;

namespace abstand::ui {

/// Fills a window's status bar. GUI thread only.
class StatusPanel : public QObject {
 public:
  explicit StatusPanel(QStatusBar* bar);
  void refresh(const SceneOutline& outline, const SceneSnapshot& snapshot);
  void clear();

 private:
  QLabel* nearest_;
  QLabel* cycle_;
  QLabel* overruns_;
  QLabel* real_time_;
};

}  // namespace abstand::ui
