// What a planned depth camera would not see of the people: question, wait and table.
#pragma once

#include <QDialog>
#include <vector>

#include "ui/document/sensor_plan.hpp"
#include "ui/model/coverage_report.hpp"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace abstand::ui {

class CoverageStrip;
class SensorEditor;

/// Does not block the window; deletes itself when it is closed. Somebody else computes. GUI thread only.
class CoverageDialog : public QDialog {
  Q_OBJECT

 public:
  CoverageDialog(const std::vector<SensorKind>& kinds, QWidget* parent);

  void setPlan(const SensorPlan& plan);
  void setTime(double t);
  /// The present plan is being computed; what was shown was of another one and disappears.
  void wait();
  /// `all` 0: files are being read.
  void showProgress(int done, int all);
  void show(const CoverageReport& report);
  void fail(const QString& problem);

  bool waiting() const { return waiting_; }
  const CoverageReport& report() const { return report_; }
  SensorEditor* editor() const { return editor_; }
  QTableWidget* table() const { return table_; }
  QLabel* sentence() const { return sentence_; }
  CoverageStrip* strip() const { return strip_; }
  static int columnOf(HiddenBy cause);
  static int stripColumn();

 Q_SIGNALS:
  /// By the user.
  void planEdited(const abstand::ui::SensorPlan& plan);
  void viewWanted();    ///< the sensor is to stand where the 3D view is seen from
  void fileWanted();    ///< lens and pose shall be those of a camera file
  void removeWanted();  ///< there is to be no sensor
  void stopped();
  void picked(double t);  ///< s

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitStrip();
  void setWaiting(bool waiting);
  void stop();
  void fillRow(int row, const CoveragePart& part);

  SensorEditor* editor_;
  QLabel* sentence_;
  QTableWidget* table_;
  CoverageStrip* strip_;
  QProgressBar* busy_;
  QPushButton* stop_;
  CoverageReport report_;
  bool waiting_{false};
};

}  // namespace abstand::ui
