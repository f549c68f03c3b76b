#include "app/studio/tune_process.hpp"

#include <algorithm>

namespace abstand::studio {

namespace {

constexpr int kKillMs = 3000;  // until a program that was asked to end is killed

/// The last non-empty line.
QString lastLine(const QString& text) {
  const QStringList lines = text.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  return lines.isEmpty() ? QString() : lines.constLast().trimmed();
}

}  // namespace

TuneProcess::TuneProcess(QString program, std::vector<int> answers)
    : program_(std::move(program)), answers_(std::move(answers)) {
  connect(&process_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this, &TuneProcess::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) Q_EMIT failed(tr("%1 cannot be started").arg(program_));
  });
}

TuneProcess::~TuneProcess() {
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.terminate();
  if (!process_.waitForFinished(kKillMs)) process_.kill();
  process_.waitForFinished(kKillMs);
}

void TuneProcess::start(const std::function<QStringList()>& words) {
  if (program_.isEmpty()) {
    Q_EMIT failed(tr("The program \"abstand\" is neither next to this program nor in PATH."));
    return;
  }
  QStringList arguments;
  try {
    arguments = words();
  } catch (const std::exception& e) {
    Q_EMIT failed(QString::fromUtf8(e.what()));
    return;
  }
  process_.setStandardInputFile(QProcess::nullDevice());
  process_.start(program_, arguments);
}

void TuneProcess::end(int code, QProcess::ExitStatus status) {
  const QString said = lastLine(QString::fromUtf8(process_.readAllStandardError()));
  const bool has_answered =
      status == QProcess::NormalExit && std::find(answers_.begin(), answers_.end(), code) != answers_.end();
  if (has_answered)
    Q_EMIT answered(process_.readAllStandardOutput(), said);
  else
    Q_EMIT failed(said.isEmpty() ? tr("%1 ended with code %2").arg(program_).arg(code) : said);
}

}  // namespace abstand::studio
