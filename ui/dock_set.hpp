// The docks of the window and their layout.
#pragma once

#include <QCoreApplication>
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
  static constexpr int kLayoutVersion = 10;

  /// The docks take the panels over. `window` and `actions` outlive this object.
  DockSet(QMainWindow& window, Actions& actions, const PanelSet& panels);

  /// Shows all docks at their first places.
  void arrange() const;
  /// Shows a dock in front of those that share its place.
  static void raise(QDockWidget* dock);

  std::array<QDockWidget*, 15> all() const {
    return {scene,  pairs,     timeline,   plots, margins, robots,    groups, notes,
            events, bookmarks, recordings, curve, cycles,  inspector, matrix};
  }

  QDockWidget *scene, *pairs, *timeline, *plots, *margins, *robots, *groups, *notes, *events, *bookmarks,
      *recordings, *curve, *cycles, *inspector, *matrix;

 private:
  QDockWidget* add(const char* name, const QString& title, const QString& tip, const QString& key,
                   QWidget* content);

  QMainWindow* window_;
  Actions* actions_;
};

}  // namespace abstand::ui
