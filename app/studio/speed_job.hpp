// Computes permitted speeds with the program `abstand`.
#pragma once

#include <QObject>

#include "app/studio/tune_call.hpp"
#include "app/studio/tune_process.hpp"
#include "ui/model/speed_proposal.hpp"

namespace abstand::studio {

/// The answer of `abstand tune --json`. Throws UsageError where it is none.
/// @param said  the last line on stderr: why no motion was written
ui::SpeedProposal speedsOf(const QByteArray& json, const QString& said);

/// Runs `abstand tune`; destruction ends it.
/// Motion files are written completely or not at all. GUI thread only.
class SpeedJob : public QObject {
  Q_OBJECT

 public:
  /// `program`: path of `abstand`.
  SpeedJob(QString program, const ui::Work& work, ui::SpeedRequest request,
           const robot_file::PackagePaths& packages, QObject* parent = nullptr);

  /// done() or failed() follows.
  void start();

 Q_SIGNALS:
  void done(const abstand::ui::SpeedProposal& proposal);
  void failed(const QString& problem);

 private:
  void end(const QByteArray& output, const QString& said);

  TuneCall call_;
  ui::SpeedRequest request_;
  QStringList separation_;  ///< KEY=VALUE of the window's separation panel
  QStringList clamped_;
  TuneProcess process_;
};

}  // namespace abstand::studio
