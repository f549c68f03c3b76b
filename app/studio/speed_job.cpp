#include "app/studio/speed_job.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::studio {

namespace {

constexpr int kSpeedKillMs = 3000;  // until a program that was asked to end is killed
constexpr int kSpeedsPartlyDone = 5, kSpeedsNotProven = 1;

QString speedNumber(double value) { return QString::fromStdString(formatDouble(value)); }

QString lastLineOf(const QString& text) {
  const QStringList lines = text.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  return lines.isEmpty() ? QString() : lines.constLast().trimmed();
}

/// What differs from the usual terms, for `--separation`.
QStringList separationTerms(const ui::SeparationSettings& settings) {
  const safety::SeparationOptions usual_options;
  std::vector<double> usual;
  safety::SeparationOptions::eachNumber(
      usual_options, [&](const char*, double value, const auto&) { usual.push_back(value); });
  QStringList terms;
  std::size_t i = 0;
  safety::SeparationOptions::eachNumber(settings.options, [&](const char* name, double value, const auto&) {
    if (value != usual[i++]) terms << QString::fromLatin1(name) + QLatin1Char('=') + speedNumber(value);
  });
  return terms;
}

/// A number of the answer. Throws UsageError.
double numberIn(const QJsonObject& json, const char* key) {
  const QJsonValue value = json.value(QLatin1String(key));
  if (!value.isDouble())
    throw UsageError(std::string("found no number `") + key +
                     "` in the answer of abstand tune, expected one");
  return value.toDouble();
}

ui::SpeedRow speedRowOf(const QJsonObject& json) {
  ui::SpeedRow row;
  row.t0 = numberIn(json, "t0");
  row.t1 = numberIn(json, "t1");
  row.scale = numberIn(json, "speed_scale");
  row.by_separation = numberIn(json, "by_separation");
  row.by_contact = numberIn(json, "by_contact");
  const QJsonValue limit = json.value(QLatin1String("limited_by"));
  if (!limit.isObject()) return row;
  row.limited = true;
  row.t = numberIn(limit.toObject(), "t");
  row.part = limit[QLatin1String("part")].toString();
  row.by_contact_limit = limit[QLatin1String("kind")].toString() == QLatin1String("contact");
  return row;
}

}  // namespace

ui::SpeedProposal speedsOf(const QByteArray& json, const QString& said) {
  const QJsonObject answer = QJsonDocument::fromJson(json).object();
  if (!answer.value(QLatin1String("speeds")).isArray())
    throw UsageError("found no answer of abstand tune, expected one with `speeds`");
  ui::SpeedProposal proposal;
  for (const QJsonValue& row : answer.value(QLatin1String("speeds")).toArray())
    proposal.rows.push_back(speedRowOf(row.toObject()));
  if (proposal.rows.empty())
    throw UsageError("found no program of a robot that moves, expected one: speeds are for its segments");
  const QJsonObject times = answer.value(QLatin1String("cycle_time")).toObject();
  proposal.recorded = numberIn(times, "as_recorded");
  proposal.permitted =
      times.value(QLatin1String("permitted")).isNull() ? kInfinity : numberIn(times, "permitted");
  if (!answer.contains(QLatin1String("proof"))) return proposal;
  for (const QJsonValue& motion : answer.value(QLatin1String("proof")).toArray())
    if (const QString file = motion[QLatin1String("file")].toString(); !file.isEmpty())
      proposal.files.push_back(file);
  if (proposal.files.empty()) proposal.not_written = said;
  return proposal;
}

SpeedJob::SpeedJob(QString program, const ui::Work& work, ui::SpeedRequest request,
                   const robot_file::PackagePaths& packages, QObject* parent)
    : QObject(parent),
      program_(std::move(program)),
      call_(work, packages),
      request_(std::move(request)),
      separation_(separationTerms(work.separation)) {
  if (work.separation.clamped)
    for (const std::string_view part : humanmodel::partNames())
      clamped_ << QString::fromUtf8(part.data(), static_cast<int>(part.size()));
  connect(&process_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this, &SpeedJob::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) Q_EMIT failed(tr("%1 cannot be started").arg(program_));
  });
}

SpeedJob::~SpeedJob() {
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.terminate();
  if (!process_.waitForFinished(kSpeedKillMs)) process_.kill();
  process_.waitForFinished(kSpeedKillMs);
}

void SpeedJob::start() {
  if (program_.isEmpty()) {
    Q_EMIT failed(tr("The program \"abstand\" is neither next to this program nor in PATH."));
    return;
  }
  try {
    QStringList words = call_.words();
    words << QStringLiteral("--json") << QStringLiteral("--speed-rule") << request_.rule
          << QStringLiteral("--segment") << speedNumber(request_.segment);
    if (!separation_.isEmpty()) words << QStringLiteral("--separation") << separation_;
    if (!clamped_.isEmpty()) words << QStringLiteral("--clamped") << clamped_;
    if (!request_.folder.isEmpty()) words << QStringLiteral("--speed-profile") << request_.folder;
    process_.setStandardInputFile(QProcess::nullDevice());
    process_.start(program_, words);
  } catch (const std::exception& e) {
    Q_EMIT failed(QString::fromUtf8(e.what()));
  }
}

void SpeedJob::end(int code, QProcess::ExitStatus status) {
  const QString said = lastLineOf(QString::fromUtf8(process_.readAllStandardError()));
  const bool answered =
      status == QProcess::NormalExit && (code == 0 || code == kSpeedsPartlyDone || code == kSpeedsNotProven);
  if (!answered) {
    Q_EMIT failed(said.isEmpty() ? tr("%1 ended with code %2").arg(program_).arg(code) : said);
    return;
  }
  try {
    Q_EMIT done(speedsOf(process_.readAllStandardOutput(), said));
  } catch (const std::exception& e) {
    Q_EMIT failed(QString::fromUtf8(e.what()));
  }
}

}  // namespace abstand::studio
