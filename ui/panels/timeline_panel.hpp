// Transport buttons, speed, time and the scrub bar.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace abstand::ui {

class Actions;
class Playback;
class TimeStrip;

/// Shows and drives a Playback; the buttons are the window's actions. GUI thread only.
class TimelinePanel : public QWidget {
  Q_OBJECT

 public:
  TimelinePanel(const Actions& actions, Playback& playback, QWidget* parent = nullptr);
  TimeStrip* strip() const { return strip_; }

 private:
  void showTime();
  void showSpeed(double factor);
  void takeSpeed();

  Playback& playback_;
  TimeStrip* strip_;
  QComboBox* speed_;
  QLabel* time_;
  QLabel* frame_;
};

}  // namespace abstand::ui
