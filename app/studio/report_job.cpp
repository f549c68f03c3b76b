#include "app/studio/report_job.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/scene_file/scene_description.hpp"
#include "app/studio/scene_of_file.hpp"
#include "app/studio/scene_of_work.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::studio {

namespace {

constexpr int kKillMs = 3000;  // until a program that was asked to end is killed
constexpr int kPartlyDone = 5;

/// The report's assumptions are those of its dialog.
ui::Work withAssumptions(ui::Work work, const ui::ReportRequest& request) {
  work.what_if.limit = request.limit;
  work.what_if.reaction_time = request.reaction_time;
  work.what_if.deceleration = request.deceleration;
  work.what_if.restart_time = request.restart_time;
  return work;
}

/// The last non-empty line.
QString lastLine(const QString& text) {
  const QStringList lines = text.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  return lines.isEmpty() ? QString() : lines.constLast().trimmed();
}

}  // namespace

ReportJob::ReportJob(QString program, ui::Work work, ui::ReportRequest request,
                     robot_file::PackagePaths packages, QObject* parent)
    : QObject(parent),
      program_(std::move(program)),
      call_(withAssumptions(std::move(work), request), std::move(packages)),
      request_(std::move(request)) {
  connect(&process_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this, &ReportJob::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) Q_EMIT failed(tr("%1 cannot be started").arg(program_));
  });
}

ReportJob::~ReportJob() {
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.terminate();
  if (!process_.waitForFinished(kKillMs)) process_.kill();
  process_.waitForFinished(kKillMs);
}

void ReportJob::start() {
  QString problem;
  if (program_.isEmpty())
    problem = tr("The program \"abstand\" is neither next to this program nor in PATH.");
  if (problem.isEmpty()) {
    try {
      const QStringList words = call_.words()
                                << QStringLiteral("--margin-set")
                                << call_.keep(QStringLiteral("present_margins.yaml"), request_.margin_set)
                                << QStringLiteral("--report") << request_.file;
      process_.setStandardInputFile(QProcess::nullDevice());
      process_.setStandardOutputFile(QProcess::nullDevice());
      return process_.start(program_, words);
    } catch (const std::exception& e) {
      problem = QString::fromUtf8(e.what());
    }
  }
  Q_EMIT failed(problem);
}

void ReportJob::end(int code, QProcess::ExitStatus status) {
  const QString said = lastLine(QString::fromUtf8(process_.readAllStandardError()));
  if (status == QProcess::NormalExit && (code == 0 || code == kPartlyDone))
    Q_EMIT done(request_.file);
  else
    Q_EMIT failed(said.isEmpty() ? tr("%1 ended with code %2").arg(program_).arg(code) : said);
}

}  // namespace abstand::studio
