// Runs `abstand` beside the window.
#pragma once

#include <QObject>
#include <QProcess>
#include <QStringList>
#include <functional>
#include <vector>

namespace abstand::studio {

/// A process of its own, so that the window keeps its pace; destruction ends it. GUI thread only.
class TuneProcess : public QObject {
  Q_OBJECT

 public:
  /// @param program  path of `abstand`; empty: it was not found
  /// @param answers  exit codes with which it has answered
  TuneProcess(QString program, std::vector<int> answers);
  ~TuneProcess() override;

  /// answered() or failed() follows. `words` makes its arguments; what it throws is the problem.
  void start(const std::function<QStringList()>& words);

 Q_SIGNALS:
  /// @param said  the last line on stderr
  void answered(const QByteArray& output, const QString& said);
  /// `problem`: the error line of the program.
  void failed(const QString& problem);

 private:
  void end(int code, QProcess::ExitStatus status);

  QString program_;
  std::vector<int> answers_;
  QProcess process_;
};

}  // namespace abstand::studio
