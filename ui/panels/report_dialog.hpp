// Asks what a report shall assume, and where it goes.
#pragma once

#include <QDialog>

#include "ui/model/report_request.hpp"

class QDoubleSpinBox;
class QLineEdit;
class QPushButton;

namespace abstand::ui {

/// GUI thread only.
class ReportDialog : public QDialog {
  Q_OBJECT

 public:
  /// Begins with the values of `request`.
  explicit ReportDialog(const ReportRequest& request, QWidget* parent = nullptr);

  /// As the fields say.
  ReportRequest request() const;

 private:
  void chooseFile();

  ReportRequest first_;
  QLineEdit* file_;
  QDoubleSpinBox *limit_, *reaction_, *deceleration_, *restart_;
  QPushButton* make_;
};

}  // namespace abstand::ui
