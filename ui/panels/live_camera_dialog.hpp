// Asks for one or two live depth cameras, and waits until it sends images.
#pragma once

#include <QDialog>

#include "ui/model/live_camera_request.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace abstand::ui {

class PathField;

/// Does not block the window; deletes itself when it is closed. Somebody else starts the camera: of wanted()
/// until fail(), or close() after a success. GUI thread only.
class LiveCameraDialog : public QDialog {
  Q_OBJECT

 public:
  explicit LiveCameraDialog(QWidget* parent);

  /// `people`: of the scene that is shown, to choose from; another name can be typed.
  void setRequest(const LiveCameraRequest& request, const QStringList& people);
  LiveCameraRequest request() const;
  void say(const QString& progress);
  void fail(const QString& problem);
  bool waiting() const { return waiting_; }
  QLabel* sentence() const { return sentence_; }
  QPushButton* startButton() const { return start_; }

 Q_SIGNALS:
  void wanted(const abstand::ui::LiveCameraRequest& request);
  void cancelled();

 private:
  void buildFields();
  void checkFields();
  void setWaiting(bool waiting);
  void ask();
  void stop();
  void applyUnits();

  PathField *scene_, *camera_, *second_;
  QComboBox* person_;
  QDoubleSpinBox* height_;
  QCheckBox* still_;
  QLabel* sentence_;
  QProgressBar* busy_;
  QPushButton *start_, *stop_;
  double metres_{0.0};
  bool waiting_{false};
};

}  // namespace abstand::ui
