#include "app/studio/report_job.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/scene_file/scene_description.hpp"
#include "app/studio/scene_of_work.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::studio {

namespace {

constexpr int kKillMs = 3000;  // until a program that was asked to end is killed
constexpr int kPartlyDone = 5;

/// In the quotes of YAML.
std::string quotedPath(const QString& path) {
  QString safe = path;
  safe.replace(QLatin1Char('\\'), QLatin1String("\\\\")).replace(QLatin1Char('"'), QLatin1String("\\\""));
  return '"' + safe.toStdString() + '"';
}

QString number(double value) { return QString::fromStdString(formatDouble(value)); }

/// The last non-empty line.
QString lastLine(const QString& text) {
  const QStringList lines = text.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  return lines.isEmpty() ? QString() : lines.constLast().trimmed();
}

}  // namespace

QString commandLineProgram() {
  const QFileInfo beside(QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("abstand")));
  return beside.isExecutable() ? beside.absoluteFilePath()
                               : QStandardPaths::findExecutable(QStringLiteral("abstand"));
}

ReportJob::ReportJob(QString program, ui::Work work, ui::ReportRequest request,
                     robot_file::PackagePaths packages, QObject* parent)
    : QObject(parent),
      program_(std::move(program)),
      work_(std::move(work)),
      request_(std::move(request)),
      packages_(std::move(packages)) {
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
  else if (!folder_.isValid())
    problem = folder_.errorString();
  if (problem.isEmpty()) {
    try {
      const QStringList words = arguments();
      process_.setStandardInputFile(QProcess::nullDevice());
      process_.setStandardOutputFile(QProcess::nullDevice());
      return process_.start(program_, words);
    } catch (const std::exception& e) {
      problem = QString::fromUtf8(e.what());
    }
  }
  Q_EMIT failed(problem);
}

QString ReportJob::keep(const QString& name, const std::string& text) const {
  const QString file = folder_.filePath(name);
  writeFile(QFile::encodeName(file).toStdString(), text);
  return file;
}

/// The scene; where the user reads its recordings or builds its people otherwise, one that says so.
QString ReportJob::sceneFile() {
  if (!changesScene(work_)) return work_.scene;
  scene_file::SceneDescription scene =
      scene_file::loadScene(QFile::encodeName(work_.scene).toStdString(), packages_);
  applyWork(work_, scene);
  return keep(QFileInfo(work_.scene).completeBaseName() + QStringLiteral("_as_read.yaml"),
              scene_file::describeScene(scene));
}

QStringList ReportJob::arguments() {
  const QString scene = sceneFile();
  QStringList words{QStringLiteral("tune")};
  if (work_.reading.speed == 1.0) {
    words << scene;
    if (!work_.recording.isEmpty()) words << QStringLiteral("--recordings") << work_.recording;
  } else {
    std::string plan = "abstand_plan: 1\nscenes: [" + quotedPath(scene) + "]\n";
    if (!work_.recording.isEmpty()) plan += "recordings: [" + quotedPath(work_.recording) + "]\n";
    plan += "speeds: [" + formatDouble(work_.reading.speed) + "]\n";
    words << keep(QStringLiteral("plan.yaml"), plan);
  }
  if (work_.reading.cut_things) words << QStringLiteral("--cut-things");
  words << QStringLiteral("--margin-set") << keep(QStringLiteral("present_margins.yaml"), request_.margin_set)
        << QStringLiteral("--limit") << number(request_.limit)  //
        << QStringLiteral("--reaction-time") << number(request_.reaction_time)
        << QStringLiteral("--deceleration") << number(request_.deceleration)
        << QStringLiteral("--restart-time") << number(request_.restart_time);
  for (const auto& folder : packages_.folders)
    words << QStringLiteral("--package-path") << QFile::decodeName(folder.c_str());
  return words << QStringLiteral("--quiet") << QStringLiteral("--report") << request_.file;
}

void ReportJob::end(int code, QProcess::ExitStatus status) {
  const QString said = lastLine(QString::fromUtf8(process_.readAllStandardError()));
  if (status == QProcess::NormalExit && (code == 0 || code == kPartlyDone))
    Q_EMIT done(request_.file);
  else
    Q_EMIT failed(said.isEmpty() ? tr("%1 ended with code %2").arg(program_).arg(code) : said);
}

}  // namespace abstand::studio
