// Safety margins of every link, body part and object, by group.
#pragma once

#include <QElapsedTimer>
#include <QMap>
#include <QScrollArea>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/view/snapshot.hpp"

class QTimer;
class QVBoxLayout;

namespace abstand::ui {

class ClassMarginRow;
class MarginRow;

/// One row an object and a master row a group, which shows the largest of its members. The first change is
/// sent at once; those that follow within kGatherMs are gathered, so that dragging a slider sends its newest
/// value instead of every one on the way. GUI thread only.
class MarginPanel : public QScrollArea {
  Q_OBJECT

 public:
  static constexpr int kGatherMs = 30;

  explicit MarginPanel(QWidget* parent = nullptr);

  /// `margins`: metres, by object.
  void open(const view::SceneOutline& outline, const std::vector<double>& margins);
  /// Other margins, without a signal.
  void show(const std::vector<double>& margins);
  /// Marks the rows of these objects, and brings the first one into view.
  void setSelected(const std::vector<int>& objects);
  /// Null for an index that is not there.
  MarginRow* row(int object) const;
  MarginRow* groupRow(const QString& group) const;
  /// A class of pairs that has a margin (m) of its own, or not, and whether that is locked; without a signal.
  void showClass(view::PairClass pair_class, const std::optional<double>& metres, bool locked);
  /// Null where the scene has no such pair.
  ClassMarginRow* classRow(view::PairClass pair_class) const;
  /// m: the largest sum of the margins of two bodies of a pair of this class.
  double largestSum(view::PairClass pair_class) const;
  /// Objects that are locked, without a signal.
  void showLocked(const std::vector<bool>& locked);
  /// As if the user moved its slider, which is held until release(). Nothing where it is locked.
  void hold(int object, double metres);
  void release();
  /// Shows only rows whose name or group contains the text; the row of a group then moves only these.
  void setFilter(const QString& text);

 Q_SIGNALS:
  /// The user changed margins (object -> metres).
  void marginsChanged(const QMap<int, double>& margins);
  /// The user wants a class of pairs to have a margin of its own, or no longer; another one (m); a lock.
  void classTicked(abstand::view::PairClass pair_class, bool on);
  void classMarginChanged(abstand::view::PairClass pair_class, double metres);
  void classLockWanted(abstand::view::PairClass pair_class, bool locked);
  /// What was sent since the last time is one edit: a drag has ended, or a value was set at once.
  void editFinished();
  /// The user wants to lock or unlock rows.
  void lockWanted(const std::vector<int>& objects, bool locked);

 private:
  void change(int object, double metres);
  void addClasses(const view::SceneOutline& outline, QWidget* content);
  void connectClass(view::PairClass pair_class, ClassMarginRow* row);
  void showSums();
  void connectRow(MarginRow* row, const std::vector<int>& objects);
  void showMasterLocks();
  bool isDragged() const;
  void send();

  struct Master {
    MarginRow* row;
    std::vector<int> objects;
    QWidget* line;  ///< below the group
    QString name;
  };
  std::vector<MarginRow*> rows_;
  std::vector<QString> names_;  ///< of the objects
  std::map<QString, MarginRow*> group_rows_;
  std::vector<Master> masters_;
  struct {
    QWidget *title{nullptr}, *line{nullptr};  ///< null: the scene has no class
    std::map<view::PairClass, ClassMarginRow*> rows;
    std::map<view::PairClass, std::vector<std::pair<int, int>>> pairs;
  } classes_;
  QString filter_;
  QMap<int, double> waiting_;
  QTimer* gather_;
  QElapsedTimer sent_;
  bool held_{false};
};

}  // namespace abstand::ui
