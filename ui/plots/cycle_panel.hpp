// Whether the loop keeps its deadline.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "ui/model/cycle_log.hpp"

class QPushButton;

namespace abstand::ui {

class ElidedLabel;
class StripChart;

/// Median, 99th and 99.9th percentile and longest wall time of the played cycles, how many missed 1 ms, the
/// nearest pair in the longest one, and the longest cycle of each frame over the time of the scene (thesis,
/// figures 5.8 and 5.13). GUI thread only.
class CyclePanel : public QWidget {
  Q_OBJECT

 public:
  explicit CyclePanel(QWidget* parent = nullptr);

  void open(const view::SceneOutline& outline);
  /// Every sample, also while the panel is hidden.
  void add(const std::vector<view::PlotSample>& samples) { log_.add(samples); }
  void setTime(double t);
  /// Shows what was added.
  void refresh();
  const CycleLog& log() const { return log_; }
  StripChart* chart() const { return chart_; }

 Q_SIGNALS:
  void timePicked(double t);

 private:
  void startAnew();
  QString nearestText() const;

  CycleLog log_;
  std::vector<QString> pairs_;  ///< "A – B", in the order of the outline
  double start_{0.0}, end_{0.0};
  std::array<ElidedLabel*, 5> values_;
  QPushButton *go_, *anew_;
  StripChart* chart_;
};

}  // namespace abstand::ui
