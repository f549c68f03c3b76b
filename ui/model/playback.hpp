// The clock as the window sees it: sends commands to the session and shows their effect at once.
#pragma once

#include <QObject>

#include "ui/model/session_port.hpp"

namespace abstand::ui {

/// A seek or step moves the shown time at once; snapshots from before the session obeyed are passed over, so
/// that the playhead does not jump back. GUI thread only.
class Playback : public QObject {
  Q_OBJECT

 public:
  static constexpr double kMinSpeed = 0.05;
  static constexpr double kMaxSpeed = 8.0;

  using QObject::QObject;

  /// Null: no session. The port must outlive its stay here.
  void setPort(SessionPort* port);
  void onSnapshot(const view::SceneSnapshot& snapshot);

  /// The times that can be shown have moved along.
  void setSpan(double start, double end);

  double time() const { return time_; }
  double start() const { return start_; }
  double end() const { return end_; }
  double framePeriod() const { return period_; }
  /// Frame of the shown time, counted from 0.
  long frame() const;
  long frameCount() const;
  bool playing() const { return playing_; }
  double speed() const { return speed_; }
  bool loop() const { return loop_; }

 public Q_SLOTS:
  void setPlaying(bool on);
  void stepFrames(int frames);
  void seek(double t);
  void jump(double seconds) { seek(time_ + seconds); }
  void toStart() { seek(start_); }
  void toEnd() { seek(end_); }
  void setSpeed(double factor);
  /// One step of the usual speeds up or down.
  void faster();
  void slower();
  void setLoop(bool on);

 Q_SIGNALS:
  void rangeChanged();
  void timeChanged(double t);
  void playingChanged(bool playing);
  void speedChanged(double factor);

 private:
  void show(double t);
  void await(double t);

  SessionPort* port_{nullptr};
  double start_{0.0}, end_{0.0}, period_{0.01};
  double time_{0.0};
  double speed_{1.0};
  bool playing_{false}, loop_{false};
  double awaited_{0.0};  // time that the session was asked for
  int patience_{0};      // snapshots that may still come from before
  bool play_asked_{false};
};

}  // namespace abstand::ui
