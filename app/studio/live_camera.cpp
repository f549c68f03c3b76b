#include "app/studio/live_camera.hpp"

#include <sys/prctl.h>

#include <QFile>
#include <QRegularExpression>
#include <csignal>

#include "app/studio/answer_number.hpp"

namespace abstand::studio {

namespace {

constexpr int kEndMs = 3000;           // until a program that was asked to end is killed
constexpr const char* kCycles = "60";  // Hz, of the server, also while nobody is seen
constexpr const char* kViewers = "3";  // this window, the tracker, and another one

/// A program that does not outlive this one, however this one ends.
class BoundProcess : public QProcess {
 protected:
  void setupChildProcess() override { ::prctl(PR_SET_PDEATHSIG, SIGTERM); }
};

QString lastLineOf(const QString& text) {
  const QStringList lines = text.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  return lines.isEmpty() ? QString() : lines.constLast().trimmed();
}

void endNow(std::unique_ptr<QProcess>& process) {
  if (!process) return;
  process->disconnect();
  if (process->state() != QProcess::NotRunning) {
    process->terminate();
    if (!process->waitForFinished(kEndMs)) process->kill();
    process->waitForFinished(kEndMs);
  }
  process.reset();
}

}  // namespace

LiveCamera::~LiveCamera() { stop(); }

void LiveCamera::stop() {
  still_.reset();
  endNow(tracker_);
  endNow(server_);
  address_.clear();
  server_said_.clear();
  tracker_said_.clear();
  lines_read_ = 0;
  sees_ = false;
}

void LiveCamera::start(const QString& program, const ui::LiveCameraRequest& request,
                       const robot_file::PackagePaths& packages) {
  stop();
  program_ = program;
  request_ = request;
  if (program_.isEmpty()) {
    Q_EMIT failed(tr("The program \"abstand\" is neither next to this program nor in PATH."));
    return;
  }
  Q_EMIT progressed(tr("Opening the scene…"));
  QStringList words{QStringLiteral("serve"),     request.scene,
                    QStringLiteral("--bind"),    QStringLiteral("127.0.0.1:0"),
                    QStringLiteral("--rate"),    QString::fromLatin1(kCycles),
                    QStringLiteral("--viewers"), QString::fromLatin1(kViewers)};
  packages_.clear();
  for (const auto& folder : packages.folders)
    packages_ << QStringLiteral("--package-path") << QFile::decodeName(folder.c_str());
  words << packages_;
  server_ = std::make_unique<BoundProcess>();
  connect(server_.get(), &QProcess::readyReadStandardError, this, &LiveCamera::readServer);
  connect(server_.get(), qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
          [this] { end(*server_, server_said_); });
  server_->setStandardOutputFile(QProcess::nullDevice());
  server_->setStandardInputFile(QProcess::nullDevice());
  server_->start(program_, words);
}

void LiveCamera::takeJoints(const std::vector<double>& joints) {
  if (!sees_ || !request_.still || joints.empty()) return;
  try {
    still_ = std::make_unique<StillRobots>(address_, joints);
  } catch (const std::exception& e) {
    Q_EMIT ended(QString::fromUtf8(e.what()));
  }
}

void LiveCamera::resetStops() {
  if (still_) still_->resetStops();
}

void LiveCamera::readServer() {
  server_said_ += QString::fromUtf8(server_->readAllStandardError());
  if (!address_.isEmpty()) return;
  static const QRegularExpression listens(QStringLiteral("serve: listening on (\\S+)\\n"));
  const QRegularExpressionMatch match = listens.match(server_said_);
  if (!match.hasMatch()) return;
  address_ = match.captured(1);
  track();
}

void LiveCamera::track() {
  Q_EMIT progressed(tr("Waiting for the camera…"));
  QStringList words{QStringLiteral("track"), QStringLiteral("live:kinect")};
  if (!request_.second.isEmpty()) words << QStringLiteral("live:kinect:2");
  for (const QString& camera : {request_.camera, request_.second})
    if (!camera.isEmpty()) words << QStringLiteral("--camera") << camera;
  words << QStringLiteral("--send") << address_ << QStringLiteral("--as") << request_.person;
  // The robots, and what else the scene has, are parts of nobody.
  words << QStringLiteral("--scene") << request_.scene << packages_;
  if (request_.height > 0.0) words << QStringLiteral("--height") << argumentOf(request_.height);
  tracker_ = std::make_unique<BoundProcess>();
  connect(tracker_.get(), &QProcess::readyReadStandardError, this, &LiveCamera::readTracker);
  connect(tracker_.get(), qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
          [this] { end(*tracker_, tracker_said_); });
  tracker_->setStandardOutputFile(QProcess::nullDevice());
  tracker_->setStandardInputFile(QProcess::nullDevice());
  tracker_->start(program_, words);
}

void LiveCamera::readTracker() {
  tracker_said_ += QString::fromUtf8(tracker_->readAllStandardError());
  readWarnings();
  if (sees_ || !tracker_said_.contains(QLatin1String("track: looking through"))) return;
  sees_ = true;
  Q_EMIT sees(address_, request_.scene);
}

void LiveCamera::readWarnings() {
  static const QString kWarning = QStringLiteral("warning: "), kOfCamera = QStringLiteral("live:"),
                       kOfScene = QStringLiteral("scene: ");
  const QStringList lines = tracker_said_.split(QLatin1Char('\n'));
  // The last one is not complete.
  for (; lines_read_ + 1 < lines.size(); ++lines_read_) {
    if (!lines[lines_read_].startsWith(kWarning)) continue;
    const QString sentence = lines[lines_read_].mid(kWarning.size());
    if (sentence.startsWith(kOfCamera)) Q_EMIT lessSeen(sentence);
    if (sentence.startsWith(kOfScene)) Q_EMIT remarked(sentence.mid(kOfScene.size()));
  }
}

void LiveCamera::end(QProcess& process, const QString& said) {
  const QString rest = said + QString::fromUtf8(process.readAllStandardError());
  const QString line = lastLineOf(rest);
  const QString problem =
      line.isEmpty() ? tr("%1 ended with code %2").arg(program_).arg(process.exitCode()) : line;
  if (sees_) {
    Q_EMIT ended(problem);
    return;
  }
  // The processes are deleted later: this is called by one of them.
  process.disconnect();
  QMetaObject::invokeMethod(
      this,
      [this, problem] {
        if (sees_) return;
        stop();
        Q_EMIT failed(problem);
      },
      Qt::QueuedConnection);
}

}  // namespace abstand::studio
