// One moment in all parts of the window.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/level_times.hpp"
#include "ui/model/time_range.hpp"
#include "ui/panel_set.hpp"

namespace abstand::ui {

class Playback;
class RecordingReview;
class RunHistory;
class SceneTreeModel;
class SessionPort;
class Viewport;
class WatchedSeries;

/// Takes a snapshot from the session and shows this one in all parts of the window. What is no matter of the
/// moment (order of the table, figures of the loop, the analysis) is refreshed apart. GUI thread only.
class MomentFeed : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    const PanelSet& panels;
    Viewport& viewport;
    SceneTreeModel& tree;
    RecordingReview& review;
    Playback& playback;
  };

  /// All outlive it.
  MomentFeed(const Parts& parts, QObject* parent);
  ~MomentFeed() override;

  /// Takes the first snapshot; null: forgets everything.
  void attach(SessionPort* session);
  /// The panels have another scene; the review is open. `margins`: m, of each object.
  void open(const view::SceneOutline& outline, const std::vector<double>& margins);
  /// Takes over what is new, and shows it.
  void pull();
  /// Shows the moment again.
  void show();
  /// At most ten times a second.
  void refreshSlow();

  /// What is shown.
  const view::SceneSnapshot& moment() const { return snapshot_; }
  RunHistory& history() const { return *history_; }
  /// What the distance plot shows beside its own line.
  WatchedSeries& watched() const { return *watched_; }
  /// Moments that were computed while playing, since the scene was opened, and came too fast to be shown.
  long missedMoments() const { return missed_; }
  /// SceneSnapshot::step that each part of the window shows.
  std::vector<std::pair<const char*, long>> shownSteps() const;

 Q_SIGNALS:
  /// All parts show moment().
  void shown();
  /// moment() is another one, and the parts do not show it yet.
  void aboutToShow();
  /// SessionPort::span() is another one; the outline has it, too.
  void spanMoved();
  /// Robots were reset to their plans at this time (s).
  void restarted(double t);

 private:
  void tellTips();
  void moveSpan();
  void openPlots(const view::SceneOutline& outline);

  Parts my_;
  SessionPort* session_{nullptr};
  std::unique_ptr<RunHistory> history_;
  WatchedSeries* watched_;
  LevelTimes times_;  ///< since when each pair is in its state
  long missed_{0};    ///< moments that were computed while playing and not shown
  view::SceneSnapshot snapshot_;
  std::vector<view::PlotSample> samples_;
  bool is_stale_{false};    ///< the tables and figures are older than the moment
  bool whole_plot_{false};  ///< the distance chart shows the whole recording, not what was played
  TimeRange span_;
  long loops_{0};  ///< SceneSnapshot::loops
};

}  // namespace abstand::ui
