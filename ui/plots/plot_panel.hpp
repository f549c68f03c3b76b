// The live plots: smallest distance, largest force, what acts on the joints, on one time axis.
#pragma once

#include <QWidget>
#include <array>

#include "core/view/snapshot.hpp"
#include "ui/model/pair_class.hpp"
#include "ui/model/watched_series.hpp"

class QComboBox;

namespace abstand::ui {

class StripChart;

/// What the plots draw. The series live in the owner and must outlive the panel or be replaced.
struct PlotSeries {
  struct Distance {
    PairClass of;
    const FrameSeries* series;
    bool certified;  ///< clearances instead of distances
  };
  std::vector<Distance> distances;  ///< in the order of the lines
  const FrameSeries *contact_force, *virtual_force, *earlier_force;
  const std::array<FrameSeries, view::kTorqueParts>* torques;  ///< in the order of TorqueParts
  const FrameSeries* earlier_torque;
};

/// The charts share their window. While following, the window moves with the playhead; zooming or dragging
/// ends that until followChanged(true) is asked for again. GUI thread only.
class PlotPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlotPanel(QWidget* parent = nullptr);

  void setSeries(const PlotSeries& series, double start, double end);
  /// Joints that can be chosen; the largest of all is chosen.
  void setJoints(const std::vector<view::SceneOutline::JointInfo>& joints);
  void setTime(double t);
  /// The figures at the time of one snapshot; they stand at the playhead until the time changes.
  /// `clearance`: m, certified, of the nearest person and robot; for lines of clearances.
  void setMoment(long step, const view::PlotSample& sample, double clearance);
  /// SceneSnapshot::step of setMoment().
  long shownStep() const { return shown_step_; }
  /// Index of the joint whose torques are shown, -1: the largest of all.
  int joint() const;
  /// Forces and torques of earlier margins have lines of their own.
  void showEarlier(bool on);
  /// Of the distance chart, after those of the classes; they live in the owner.
  void setWatched(const std::vector<WatchedSeries::Line>& lines);
  /// Shown as a band in the distance chart, m; 0: none.
  void setMargin(double metres);
  void refresh();
  std::vector<StripChart*> charts() const { return {charts_.begin(), charts_.end()}; }
  bool following() const { return follow_; }

 public Q_SLOTS:
  void setFollow(bool on);

 Q_SIGNALS:
  void timePicked(double t);
  void followChanged(bool on);
  /// Index of the joint whose torques are wanted, -1: the largest of all.
  void jointChosen(int joint);
  /// The user has dropped these on the plots.
  void dropped(const std::vector<abstand::ui::Watched>& watched);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void nameTorques();
  void layLines();
  void moveWindow(double left, double right);
  void followTime();

  std::array<StripChart*, 3> charts_;
  PlotSeries series_{};
  std::vector<WatchedSeries::Line> watched_;
  bool earlier_{false};
  QComboBox *span_, *joint_;
  std::vector<bool> prismatic_;  ///< of each joint
  double start_{0.0}, end_{0.0}, time_{0.0};
  bool follow_{true};
  long shown_step_{-1};
};

}  // namespace abstand::ui
