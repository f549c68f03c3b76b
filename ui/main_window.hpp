// The window: builds the panels and connects them.
#pragma once

#include <QMainWindow>
#include <memory>
#include <vector>

#include "ui/document/session_follower.hpp"
#include "ui/model/kept_selection.hpp"
#include "ui/model/session_port.hpp"
#include "ui/panel_set.hpp"

class QSlider;
class QTimer;

namespace abstand::ui {

class Actions;
class Autosave;
class DockSet;
class Document;
class MarginCommands;
class Playback;
class ProjectCommands;
class RecordingReview;
class ReportCommands;
class RunHistory;
class SceneTreeModel;
class Selection;
class TimeAxis;
class VideoRecorder;
class Viewport;
struct LeftOver;
struct Opening;

/// Takes a snapshot from the session for each picture, and shows this one in all parts of the window before
/// it takes the next. What is no matter of the moment (order of the table, figures of the loop, the analysis)
/// is refreshed at most ten times a second. GUI thread only. Needs prepareOpenGl() before the QApplication,
/// and the names of organisation and program for its settings.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Shows a session as the document has it; null for none. The session must outlive its stay here. Layout,
  /// selection and camera stay.
  void setSession(SessionPort* session);
  /// Takes over what is new now, instead of at the next tick.
  void pull();
  /// Says what went wrong (an error's text) without blocking.
  void showProblem(const QString& title, const QString& text);
  /// In the status bar, until hideOpening().
  void showOpening(const Opening& opening);
  void hideOpening();

  /// Keeps autosaves of the document in a folder, and offers what it finds there.
  void keepAutosaves(const QString& folder);

  Document& document() const { return *document_; }
  ProjectCommands& projects() const { return *projects_; }
  VideoRecorder& videos() const { return *outputs_.videos; }
  ReportCommands& reports() const { return *outputs_.reports; }
  const Actions& actions() const { return *actions_; }
  Playback& playback() const { return *playback_; }
  Selection& selection() const { return *selection_; }
  Viewport& viewport() const { return *viewport_; }
  const PanelSet& panels() const { return panels_; }
  /// The whole recording under the present margins.
  RecordingReview& review() const { return *review_; }
  /// What the lanes show, and the range between IN and OUT.
  TimeAxis& timeAxis() const { return *axis_; }
  /// What is shown.
  const view::SceneSnapshot& moment() const { return snapshot_; }
  /// SceneSnapshot::step that each part of the window shows.
  std::vector<std::pair<const char*, long>> shownSteps() const;

 public Q_SLOTS:
  /// Asks for the file by its kind, and remembers it.
  void openFile(const QString& path);

 Q_SIGNALS:
  /// All parts of the window show moment().
  void momentShown();
  void openSceneRequested(const QString& path);
  void openRecordingRequested(const QString& path);
  /// `modified`: `project` is not what `file` holds.
  void openProjectRequested(const abstand::ui::Project& project, const QString& file, bool modified);
  /// What is shown shall be read again with this person changed; an edit of the document once it is there.
  void personRequested(const QString& name, const abstand::ui::PersonOptions& options);
  /// What is shown shall be read again.
  void reloadRequested();
  /// The user does not want to wait for what is being opened.
  void cancelRequested();
  /// The user wants to begin with nothing.
  void closeRequested();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildPanels();
  void connectFile();
  void connectView();
  void connectPlayback();
  void connectPanels();
  void connectReview();
  void choosePair(int part, int link);
  void connectDocument();
  void connectUndo();
  void connectProjects();
  void connectBookmarks();
  void showBookmarks();
  void connectEdits();
  void connectGroups();
  void connectInspector();
  void poseJoint(int robot, int joint, double value);
  void checkPair(int a, int b, bool checked);
  void followWork(const Work& before, const Work& after);
  void showDocument();
  void showHidden(const QSet<QString>& before, const QSet<QString>& after);
  void showView();
  void showTitle();
  void attachDocument();
  void openFiles(const QStringList& paths);
  QString nameOf(int object) const;
  void restore();
  void save() const;
  void showRecent();
  void showStart();
  void applyOptions();
  void showMoment();
  void refreshSlow();
  void goToEvent(bool next);
  void connectVideo();
  void savePlotsAs();
  void saveScreenshot();

  std::unique_ptr<RunHistory> history_;
  SessionPort* session_{nullptr};
  view::SceneSnapshot snapshot_;
  std::vector<view::PlotSample> samples_;

  Document* document_;
  ProjectCommands* projects_;
  struct {
    ReportCommands* reports;
    VideoRecorder* videos;
  } outputs_;
  MarginCommands* margin_commands_{nullptr};
  struct {
    Autosave* autosave{nullptr};
    std::unique_ptr<LeftOver> recovered;  ///< until its work is in an autosave of this program
  } kept_;
  SessionFollower follower_;
  KeptSelection kept_selection_;
  bool fresh_document_{true};  // no session was shown since it was opened

  Actions* actions_;
  Playback* playback_;
  RecordingReview* review_;
  TimeAxis* axis_;
  Selection* selection_;
  SceneTreeModel* tree_model_;
  Viewport* viewport_;
  PanelSet panels_;
  std::unique_ptr<DockSet> docks_;
  QSlider* opacity_;
  QTimer* pull_timer_;
  QTimer* slow_timer_;
  /// What the panels show.
  struct {
    bool is_stale{false};    ///< the tables and figures are older than the moment
    bool whole_plot{false};  ///< the distance chart shows the whole recording, not what was played
    long loops{0};           ///< SceneSnapshot::loops
  } shown_;
};

}  // namespace abstand::ui
