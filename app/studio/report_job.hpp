// Makes a report with the program `abstand`.
#pragma once

#include <QObject>
#include <QString>

#include "app/studio/tune_call.hpp"
#include "app/studio/tune_process.hpp"
#include "ui/model/report_request.hpp"

namespace abstand::studio {

/// Runs `abstand tune --report` over what a document shows: its scene, recording, reading options and
/// margins. Destruction ends the process; a page is written completely or not at all. GUI thread only.
class ReportJob : public QObject {
  Q_OBJECT

 public:
  /// `program`: path of `abstand`.
  ReportJob(QString program, ui::Work work, ui::ReportRequest request, robot_file::PackagePaths packages,
            QObject* parent = nullptr);

  /// done() or failed() follows.
  void start();

 Q_SIGNALS:
  void done(const QString& file);
  /// `problem`: the error line of the program.
  void failed(const QString& problem);

 private:
  TuneCall call_;
  ui::ReportRequest request_;
  TuneProcess process_;
};

}  // namespace abstand::studio
