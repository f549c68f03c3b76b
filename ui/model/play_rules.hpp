// Where play goes back or pauses by itself: the chosen range, and events.
#pragma once

#include <QObject>

namespace abstand::ui {

class Playback;
class RecordingReview;
class TimeAxis;

/// While it plays with Loop on, time goes from OUT back to IN. With setPauseOnEvents() play stops where an
/// event of the review begins. GUI thread only.
class PlayRules : public QObject {
  Q_OBJECT

 public:
  /// All of them outlive it.
  PlayRules(Playback& playback, const TimeAxis& axis, const RecordingReview& review, QObject* parent);

  void setPauseOnEvents(bool on) { pause_on_events_ = on; }
  bool pauseOnEvents() const { return pause_on_events_; }

 Q_SIGNALS:
  /// Play was paused at the event at `t` (s).
  void pausedAt(double t);

 private:
  void follow(double t);

  Playback& playback_;
  const TimeAxis& axis_;
  const RecordingReview& review_;
  bool pause_on_events_{false}, following_{false};
  int patience_{0};   ///< times that may still come from before the session went back to IN
  double last_{0.0};  ///< s, the time that was shown before
};

}  // namespace abstand::ui
