// Transport buttons, speed, time, the scrub bar and the lanes.
#pragma once

#include <QWidget>

#include "ui/model/stop_spans.hpp"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;

namespace abstand::ui {

class Actions;
class CompareLanes;
class LaneView;
class Playback;
class RecordingReview;
class TimeAxis;
class TimeMinimap;
class TimeStrip;

/// Shows and drives a Playback; the buttons are the window's actions. Lanes and the sentence on the present
/// margins are there while the review is available. GUI thread only.
class TimelinePanel : public QWidget {
  Q_OBJECT

 public:
  /// All of them outlive it.
  TimelinePanel(const Actions& actions, Playback& playback, const RecordingReview& review, TimeAxis& axis,
                QWidget* parent = nullptr);
  /// What robots that react do at this moment.
  void refresh(const view::SceneSnapshot& snapshot);
  /// Of the people that are shown: the first that states when it was recorded makes the times of day.
  void setRecordings(const std::vector<view::RecordingCard>& cards);
  /// When robots stood, as far as it was played.
  const std::vector<StopSpan>& stops() const { return stops_.spans(); }
  TimeStrip* strip() const { return strip_; }
  LaneView* laneView() const { return lanes_; }
  TimeMinimap* minimap() const { return minimap_; }
  CompareLanes* compareLanes() const { return compare_; }
  /// Where a time is typed.
  QLineEdit* timeField() const { return go_to_; }
  QLabel* whatIf() const { return what_if_; }
  /// The time that is shown.
  QLabel* timeLabel() const { return time_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildTransport(const Actions& actions);
  void showTime();
  void showReview();
  void goToTyped();
  void showSpeed(double factor);
  void takeSpeed();

  StopSpans stops_;
  Playback& playback_;
  const RecordingReview& review_;
  TimeAxis& axis_;
  TimeStrip* strip_;
  CompareLanes* compare_;
  LaneView* lanes_;
  TimeMinimap* minimap_;
  QLineEdit* go_to_;
  QLabel* what_if_;
  QLabel* no_lanes_;
  QComboBox* speed_;
  QLabel* time_;
  QLabel* frame_;
  QAction* by_clock_;
  double clock_start_{kNaN};  // s since 1970 UTC at t = 0
};

}  // namespace abstand::ui
