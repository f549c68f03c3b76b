// The docks of the window and their layout.
#pragma once

#include <QByteArray>
#include <QCoreApplication>
#include <QSize>
#include <array>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace abstand::ui {

class Actions;
struct PanelSet;

/// A dock for each panel, with an action that shows it in front, or hides it where it is in front. The window
/// owns the docks. GUI thread only.
class DockSet {
  Q_DECLARE_TR_FUNCTIONS(DockSet)

 public:
  /// To be increased when docks are added or removed, so that an old layout is not applied to a new window.
  static constexpr int kLayoutVersion = 13;

  /// The docks take the panels over. `window` and `actions` outlive this object.
  DockSet(QMainWindow& window, Actions& actions, const PanelSet& panels);

  /// Shows the docks at their first places, those that are seldom needed hidden.
  void arrange() const;
  /// Gives the docks sizes that fit that of the window.
  void fitSize() const;
  /// What a user is about to do.
  enum class Task { kReplay, kTuning, kReview };
  /// The first places, with only those docks that the task needs.
  void arrangeFor(Task task) const;
  /// For project files.
  QByteArray layout() const;
  /// A layout of another version, or a damaged one, changes nothing. The window keeps its size.
  void restore(const QByteArray& layout) const;
  /// Shows a dock in front of those that share its place.
  static void raise(QDockWidget* dock);

  std::array<QDockWidget*, 20> all() const {
    return {scene,      pairs, timeline, plots,     margins, robots,     groups, notes,   events, bookmarks,
            recordings, curve, cycles,   inspector, matrix,  separation, log,    history, depth,  reactions};
  }

  QDockWidget *scene, *pairs, *timeline, *plots, *margins, *robots, *groups, *notes, *events, *bookmarks,
      *recordings, *curve, *cycles, *inspector, *matrix, *separation, *log, *history, *depth, *reactions;

 private:
  /// The 3D view would have no room above both timeline and tables: they share a place.
  void fitLowWindow() const;
  /// Hides the docks that a task does not need.
  void keepOnly(Task task) const;
  void keepSize(const QSize& size) const;
  QDockWidget* add(const char* name, const QString& title, const QString& tip, const QString& key,
                   QWidget* content);

  QMainWindow* window_;
  Actions* actions_;
};

}  // namespace abstand::ui
