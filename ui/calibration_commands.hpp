// View > Calibrate a depth camera.
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/model/calibration_request.hpp"

class QWidget;

namespace abstand::ui {

class CalibrationDialog;

/// Somebody else computes: of wanted() until done(), fail() or cancelled(). One at a time. The dialog belongs
/// to `window`. GUI thread only.
class CalibrationCommands : public QObject {
  Q_OBJECT

 public:
  explicit CalibrationCommands(QWidget* window);

  /// Another scene is shown, with these robots.
  void setRobots(const QStringList& robots);
  /// Shows the dialog, as it was last.
  void open();
  void done(const CalibrationAnswer& answer);
  void fail(const QString& problem);
  /// Null: closed.
  CalibrationDialog* dialog() const;

 Q_SIGNALS:
  void wanted(const abstand::ui::CalibrationRequest& request);
  void cancelled();
  void said(const QString& text);
  void failed(const QString& title, const QString& problem);

 private:
  void save(const QByteArray& camera);

  QWidget* window_;
  QStringList robots_;
  CalibrationRequest last_;
  QPointer<CalibrationDialog> dialog_;
};

}  // namespace abstand::ui
