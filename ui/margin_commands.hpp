// What the commands of the margin workbench do to the document.
#pragma once

#include <QMap>
#include <QObject>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/view/snapshot.hpp"

class QWidget;

namespace abstand::ui {

class Actions;
class Document;
class MarginPanel;
class RecordingReview;
class SessionFollower;
struct Work;

/// Presets, locks, the clipboard, files of margin sets, and proposed margins: one undo step each. A locked
/// margin stays. Dialogs belong to `window`. GUI thread only.
class MarginCommands : public QObject {
  Q_OBJECT

 public:
  /// All of them outlive it.
  MarginCommands(Document& document, const SessionFollower& follower, RecordingReview& review,
                 MarginPanel& panel, const Actions& actions, QWidget* window);

  /// Of the session that is shown; null: none. It must outlive its stay here.
  void open(const view::SceneOutline* outline);
  /// The present margins as the text of a file of margins; empty, with said(), where the scene has no pair of
  /// a person and a robot.
  std::string presentSet();
  /// m, of objects. `also` changes more in the same step.
  void set(const QString& text, const QMap<int, double>& margins, const QString& merge_key = {},
           const std::function<void(Work&)>& also = {});
  /// m, of all pairs of a class; nullopt: the sums of the objects' margins again. A locked class stays.
  void setClass(view::PairClass pair_class, std::optional<double> metres);

 Q_SIGNALS:
  void said(const QString& text);
  void failed(const QString& title, const QString& problem);
  /// m, of each object: what the present margins are compared with; empty: nothing.
  void compared(const std::vector<double>& margins);
  /// s; indices of the analysis' store.
  void picked(double t, int part, int link);

 public Q_SLOTS:
  /// Takes over a file of margins; failed() where it cannot be.
  void openFile(const QString& file);
  void openSet();
  /// Compares with the present margins, or no longer.
  void compare(bool on);

 private:
  void connectPanel();
  void connectActions();
  void connectClasses();
  void tickClass(view::PairClass pair_class, bool on);
  void lockClass(view::PairClass pair_class, bool locked);
  void showClasses();
  void takeClasses(const std::map<std::string, double>& classes, Work& work) const;
  void setAll(double metres);
  void reset();
  void lock(const std::vector<int>& objects, bool locked);
  void showLocks();
  QString name(int object) const;
  bool locked(int object) const;
  std::vector<double> margins() const;
  void takeSet(const std::string& text, const QString& from, const QString& step);
  void copy();
  void paste();
  void saveSet();
  void propose();
  void showCompared();

  Document& document_;
  const SessionFollower& follower_;
  RecordingReview& review_;
  MarginPanel& panel_;
  const Actions& actions_;
  QWidget* window_;
  const view::SceneOutline* outline_{nullptr};
};

}  // namespace abstand::ui
