// Safety margins of every link, body part and object, by group.
#pragma once

#include <QScrollArea>
#include <map>
#include <vector>

#include "core/view/snapshot.hpp"

class QTimer;
class QVBoxLayout;

namespace abstand::ui {

class MarginRow;

/// One row an object and a master row a group. Changes are gathered for a moment, so that dragging a slider
/// sends its newest value instead of every one on the way. GUI thread only.
class MarginPanel : public QScrollArea {
  Q_OBJECT

 public:
  static constexpr int kGatherMs = 30;

  explicit MarginPanel(QWidget* parent = nullptr);

  /// `margins`: metres, by object; what reset() returns to.
  void open(const view::SceneOutline& outline, const std::vector<double>& margins);
  /// Null for an index that is not there.
  MarginRow* row(int object) const;
  MarginRow* groupRow(const QString& group) const;

 public Q_SLOTS:
  void reset();

 Q_SIGNALS:
  void marginChanged(int object, double metres);

 private:
  void change(int object, double metres);
  void send();

  std::vector<MarginRow*> rows_;
  std::map<QString, MarginRow*> group_rows_;
  std::vector<std::pair<MarginRow*, std::vector<int>>> masters_;
  std::vector<double> first_;
  std::map<int, double> waiting_;
  QTimer* gather_;
};

}  // namespace abstand::ui
