// The pose of a depth camera: question, wait, residual and camera file.
#pragma once

#include <QDialog>

#include "ui/model/calibration_request.hpp"

class QComboBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace abstand::ui {

class BoardFields;
class PathField;

/// Does not block the window; deletes itself when it is closed. Somebody else computes: of wanted() until
/// show() or fail(). GUI thread only.
class CalibrationDialog : public QDialog {
  Q_OBJECT

 public:
  /// `robots`: of the scene that is shown.
  CalibrationDialog(const QStringList& robots, QWidget* parent);

  void setRequest(const CalibrationRequest& request);
  CalibrationRequest request() const;
  void show(const CalibrationAnswer& answer);
  void fail(const QString& problem);
  bool waiting() const { return waiting_; }
  QLabel* sentence() const { return sentence_; }
  QTableWidget* table() const { return table_; }
  QPushButton* computeButton() const { return compute_; }
  QPushButton* saveButton() const { return save_; }

 Q_SIGNALS:
  void wanted(const abstand::ui::CalibrationRequest& request);
  void cancelled();
  /// The content of a camera file shall be saved.
  void saveWanted(const QByteArray& camera);

 private:
  CalibrationMode mode() const;
  void buildFields(const QStringList& robots);
  void showMode();
  void checkFields();
  void setWaiting(bool waiting);
  void ask();
  void stop();
  void forget();

  QComboBox* mode_;
  QLabel* hint_;
  QGridLayout* form_;
  PathField *camera_, *clip_, *reference_, *images_, *points_;
  QComboBox* robot_;
  BoardFields* board_;
  QTableWidget* table_;
  QLabel* sentence_;
  QProgressBar* busy_;
  QPushButton *compute_, *save_, *stop_;
  QByteArray found_;  ///< content of the camera file; empty: none
  bool waiting_{false};
};

}  // namespace abstand::ui
