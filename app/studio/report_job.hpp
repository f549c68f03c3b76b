// Makes a report with the program `abstand`.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QTemporaryDir>

#include "core/robot_file/mesh_reference.hpp"
#include "ui/document/work.hpp"
#include "ui/model/report_request.hpp"

namespace abstand::studio {

/// Path of `abstand`: beside this program, otherwise in PATH; empty if it is in neither.
QString commandLineProgram();

/// Runs `abstand tune --report` over what a document shows: its scene, recording, reading options and
/// margins. A process of its own, so that the window keeps its pace. Destruction ends the process; a page is
/// written completely or not at all. GUI thread only.
class ReportJob : public QObject {
  Q_OBJECT

 public:
  /// `program`: path of `abstand`.
  ReportJob(QString program, ui::Work work, ui::ReportRequest request, robot_file::PackagePaths packages,
            QObject* parent = nullptr);
  ~ReportJob() override;

  /// done() or failed() follows.
  void start();

 Q_SIGNALS:
  void done(const QString& file);
  /// `problem`: the error line of the program.
  void failed(const QString& problem);

 private:
  QStringList arguments();
  QString sceneFile();
  QString keep(const QString& name, const std::string& text) const;
  void end(int code, QProcess::ExitStatus status);

  QString program_;
  ui::Work work_;
  ui::ReportRequest request_;
  robot_file::PackagePaths packages_;
  QTemporaryDir folder_;
  QProcess process_;
};

}  // namespace abstand::studio
