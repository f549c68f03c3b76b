// Finds the pose of a depth camera with the program `abstand`.
#pragma once

#include <QObject>
#include <QTemporaryDir>

#include "app/studio/tune_call.hpp"
#include "app/studio/tune_process.hpp"
#include "ui/model/calibration_request.hpp"

namespace abstand::studio {

/// The answer of `abstand calibrate --json` without the content of the camera file. Throws UsageError where
/// it is none.
ui::CalibrationAnswer calibrationOf(const QByteArray& json);

/// Runs `abstand calibrate`; destruction ends it. GUI thread only.
class CalibrationJob : public QObject {
  Q_OBJECT

 public:
  /// `program`: path of `abstand`. `work`: its scene is that of the robot.
  CalibrationJob(QString program, const ui::Work& work, ui::CalibrationRequest request,
                 const robot_file::PackagePaths& packages, QObject* parent = nullptr);

  /// done() or failed() follows.
  void start();

 Q_SIGNALS:
  void done(const abstand::ui::CalibrationAnswer& answer);
  /// `problem`: the error line of the program.
  void failed(const QString& problem);

 private:
  QStringList words() const;
  void end(const QByteArray& output);

  TuneCall call_;
  ui::CalibrationRequest request_;
  robot_file::PackagePaths packages_;
  QTemporaryDir folder_;
  TuneProcess process_;
};

}  // namespace abstand::studio
