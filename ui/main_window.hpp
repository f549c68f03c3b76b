// The window: builds the panels and connects them.
#pragma once

#include <QMainWindow>
#include <memory>
#include <vector>

#include "ui/model/session_port.hpp"

class QDockWidget;
class QSlider;
class QTimer;

namespace abstand::ui {

class Actions;
class BookmarkPanel;
class Bookmarks;
class EventPanel;
class GroupPanel;
class MarginPanel;
class NotePanel;
class PairPanel;
class Playback;
class PlayRules;
class PlotPanel;
class RecordingReview;
class RobotPanel;
class RunHistory;
class SceneTreeModel;
class SceneTreePanel;
class Selection;
class StatusPanel;
class TimeAxis;
class TimelinePanel;
class Viewport;
struct Opening;

/// Pulls snapshots from a session about 60 times a second and hands them on: the viewport at once, tables and
/// plots at most ten times a second. GUI thread only. Needs prepareOpenGl() before the QApplication, and the
/// names of organisation and program for its settings.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Shows a session; null for none. The session must outlive its stay here. Layout and view settings stay.
  void setSession(SessionPort* session);
  /// Takes over what is new now, instead of at the next tick.
  void pull();
  /// Says what went wrong (an error's text) without blocking.
  void showProblem(const QString& title, const QString& text);
  /// In the status bar, until hideOpening().
  void showOpening(const Opening& opening);
  void hideOpening();

  const Actions& actions() const { return *actions_; }
  Playback& playback() const { return *playback_; }
  Selection& selection() const { return *selection_; }
  Viewport& viewport() const { return *viewport_; }
  MarginPanel& marginPanel() const { return *margins_; }
  PairPanel& pairPanel() const { return *pairs_; }
  TimelinePanel& timelinePanel() const { return *timeline_; }
  RobotPanel& robotPanel() const { return *robots_; }
  GroupPanel& groupPanel() const { return *groups_; }
  NotePanel& notePanel() const { return *notes_; }
  EventPanel& eventPanel() const { return *events_; }
  /// The whole recording under the present margins.
  RecordingReview& review() const { return *review_; }
  /// What the lanes show, and the range between IN and OUT.
  TimeAxis& timeAxis() const { return *axis_; }
  Bookmarks& bookmarks() const { return *bookmarks_; }
  BookmarkPanel& bookmarkPanel() const { return *bookmark_panel_; }

 public Q_SLOTS:
  /// Asks for the file by its kind, and remembers scenes.
  void openFile(const QString& path);

 Q_SIGNALS:
  void openSceneRequested(const QString& path);
  void openRecordingRequested(const QString& path);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildDocks();
  QDockWidget* addDock(const char* name, const QString& title, const QString& tip, const QString& key,
                       QWidget* content);
  void arrangeDocks();
  void connectFile();
  void connectView();
  void connectPlayback();
  void connectPanels();
  void connectReview();
  void choosePair(int part, int link);
  void restore();
  void save() const;
  void showRecent();
  void applyOptions();
  void refreshSlow();
  void goToEvent(bool next);
  void saveScreenshot();

  std::unique_ptr<RunHistory> history_;
  SessionPort* session_{nullptr};
  view::SceneSnapshot snapshot_;
  std::vector<view::PlotSample> samples_;

  Actions* actions_;
  Playback* playback_;
  RecordingReview* review_;
  TimeAxis* axis_;
  PlayRules* rules_;
  Bookmarks* bookmarks_;
  Selection* selection_;
  SceneTreeModel* tree_model_;
  Viewport* viewport_;
  SceneTreePanel* tree_;
  PairPanel* pairs_;
  PlotPanel* plots_;
  MarginPanel* margins_;
  RobotPanel* robots_;
  GroupPanel* groups_;
  NotePanel* notes_;
  EventPanel* events_;
  BookmarkPanel* bookmark_panel_;
  TimelinePanel* timeline_;
  StatusPanel* status_;
  QSlider* opacity_;
  QTimer* pull_timer_;
  QTimer* slow_timer_;
  std::vector<QDockWidget*> docks_;
  bool news_{false};
  bool whole_plot_{false};  // the distance chart shows the whole recording, not what was played
  long loops_{0};           // SceneSnapshot::loops that was shown last
};

}  // namespace abstand::ui
