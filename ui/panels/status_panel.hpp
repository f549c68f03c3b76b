// The status bar: what this is not, nearest pair, robots that react, what was left out, speed; and how far
// the opening of a scene is.
#pragma once

#include <QObject>
#include <optional>

#include "core/view/snapshot.hpp"
#include "ui/model/live_status.hpp"

class QProgressBar;
class QStatusBar;
class QToolButton;

namespace abstand::ui {

class ElidedLabel;
class RecordingReview;

/// How far the opening of a scene is.
struct Opening {
  int images_done{0};    ///< of a depth recording
  int images{0};         ///< 0: no depth recording is being read
  int begun{0};          ///< structures that are done or under way; 0: files are being read
  int all{0};            ///< structures in all
  QString name{};        ///< of the structure that was heard of last
  bool building{false};  ///< it is being built; else it came from the cache, or it is not known yet
  double fraction{0.0};  ///< 0 to 1, of the work
};

/// Fills a window's status bar. GUI thread only.
class StatusPanel : public QObject {
  Q_OBJECT

 public:
  explicit StatusPanel(QStatusBar* bar);
  /// What holds at the shown moment.
  void refresh(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);
  /// Figures of the loop over a while; at most ten times a second.
  /// `missed`: moments that were computed while playing and not shown.
  void refreshFigures(const view::SceneSnapshot& snapshot, long missed);
  /// SceneSnapshot::step of the last refresh().
  long shownStep() const { return shown_step_; }
  void clear();
  /// Ends the opening; shown with its progress.
  QToolButton* cancelButton() const { return cancel_; }
  /// Takes the place of the nearest pair, until hideOpening().
  void showOpening(const Opening& opening);
  void hideOpening();
  /// How the connection with a server is; nothing: the session is our own.
  void showLive(const std::optional<LiveStatus>& status);
  /// How far the analysis of the recording is; nothing once it is done.
  void showAnalysis(const RecordingReview& review);

 private:
  void showRobots(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);

  long shown_step_{-1};
  ElidedLabel* nearest_;
  ElidedLabel* opening_;
  QProgressBar* opening_bar_;
  QToolButton* cancel_;
  ElidedLabel* live_;
  ElidedLabel* analysis_;
  ElidedLabel* robots_;
  ElidedLabel* left_out_;
  ElidedLabel* cycle_;
  ElidedLabel* overruns_;
  ElidedLabel* real_time_;
};

}  // namespace abstand::ui
