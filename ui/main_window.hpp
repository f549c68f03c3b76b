// The window: builds the panels and connects them.
#pragma once

#include <QMainWindow>
#include <memory>
#include <vector>

#include "ui/document/session_follower.hpp"
#include "ui/model/body_inside.hpp"
#include "ui/model/kept_selection.hpp"
#include "ui/model/session_port.hpp"
#include "ui/panel_set.hpp"

class QSlider;
class QTimer;

namespace abstand::ui {

class Actions;
class Autosave;
class CalibrationCommands;
class CameraCommands;
class CloudCommands;
class CoverageCommands;
class DockSet;
class ExchangeCommands;
class Document;
class FileCommands;
class ImportCommands;
class LinkDrag;
class LinkPoke;
class LiveCameraCommands;
class LiveCommands;
class LogBook;
class MarginCommands;
class MomentFeed;
class Playback;
class ProjectCommands;
class RecordingReview;
class ReportCommands;
class SceneEdits;
class SceneTreeModel;
class Selection;
class SpeedCommands;
class VerificationCommands;
class StartPage;
class ThingDrag;
class TimeAxis;
class VideoRecorder;
class Viewport;
struct LeftOver;
struct Opening;

/// Builds docks and commands and connects them. MomentFeed shows a snapshot of the session for each picture,
/// this one in all parts of the window before it takes the next. GUI thread only. Needs prepareOpenGl()
/// before the QApplication, and the names of organisation and program for its settings.
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
  /// For the status bar and the log.
  void say(const QString& text);
  /// In the status bar, until hideOpening().
  void showOpening(const Opening& opening);
  void hideOpening();

  /// Keeps autosaves of the document in a folder, and offers what it finds there.
  void keepAutosaves(const QString& folder);

  Document& document() const { return *document_; }
  FileCommands& files() const { return *commands_.files; }
  ProjectCommands& projects() const { return *commands_.projects; }
  VideoRecorder& videos() const { return *commands_.videos; }
  ExchangeCommands& exchange() const { return *commands_.exchange; }
  LiveCommands& live() const { return *commands_.live; }
  ImportCommands& imports() const { return *commands_.imports; }
  CloudCommands& clouds() const { return *commands_.clouds; }
  LiveCameraCommands& liveCamera() const { return *commands_.live_camera; }
  CalibrationCommands& calibration() const { return *commands_.calibration; }
  CoverageCommands& coverage() const { return *commands_.coverage; }
  SpeedCommands& speeds() const { return *commands_.speeds; }
  VerificationCommands& verification() const { return *commands_.verification; }
  ReportCommands& reports() const { return *commands_.reports; }
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
  const view::SceneSnapshot& moment() const;
  /// SceneSnapshot::step that each part of the window shows.
  std::vector<std::pair<const char*, long>> shownSteps() const;

 public Q_SLOTS:
  void setVisible(bool visible) override;
  /// Asks for the file by its kind, and remembers it.
  void openFile(const QString& path);

 Q_SIGNALS:
  /// All parts of the window show moment().
  void momentShown();
  void openSceneRequested(const QString& path);
  void openRecordingRequested(const QString& path);
  void openMomentsRequested(const QString& path);
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
  void buildCommands();
  void connectView();
  void connectTime();
  void connectSession();
  void connectPicks();
  void connectSelection();
  void connectHelp();
  void followUnits();
  void lookInside(InsideView view, int level);
  void pinSelection();
  void connectInspector();
  void connectDocument();
  void connectUndo();
  void connectProjects();
  void connectBookmarks();
  void connectMargins();
  void followSpan();
  void openPanels(const view::SceneOutline& outline);
  void enableActions(const view::SceneOutline& outline);
  void choosePair(int pair);
  void chooseLane(int part, int link);
  void followWork(const Work& before, const Work& after);
  void showBookmarks();
  void showDocument();
  void showHidden(const QSet<QString>& before, const QSet<QString>& after);
  void showView();
  void showTitle();
  void attachDocument();
  QString nameOf(int object) const;
  void showStart();
  void applyOptions();

  SessionPort* session_{nullptr};
  Document* document_;
  /// Objects that do what the commands of the window say.
  struct {
    ProjectCommands* projects;
    FileCommands* files;
    ReportCommands* reports;
    VideoRecorder* videos;
    MarginCommands* margins;
    SceneEdits* scene;
    CameraCommands* camera;
    ExchangeCommands* exchange;
    ImportCommands* imports;
    LinkDrag* drag;
    LiveCommands* live;
    LinkPoke* poke;
    ThingDrag* things;
    SpeedCommands* speeds;
    VerificationCommands* verification;
    CloudCommands* clouds;
    CoverageCommands* coverage;
    CalibrationCommands* calibration;
    LiveCameraCommands* live_camera;
  } commands_{};
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
  MomentFeed* feed_;
  LogBook* log_;
  StartPage* start_;
  QSlider* opacity_;
  bool arrange_at_first_show_{false};  // no layout was kept
  struct {
    QTimer *pull, *slow;
  } timers_{};
};

}  // namespace abstand::ui
