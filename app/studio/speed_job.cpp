#include "app/studio/speed_job.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "app/studio/answer_number.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::studio {

namespace {

constexpr int kSpeedsDone = 0, kSpeedsNotProven = 1, kSpeedsPartlyDone = 5;
constexpr const char* kTune = "abstand tune";

/// What differs from the usual terms, for `--separation`.
QStringList separationTerms(const ui::SeparationSettings& settings) {
  QStringList terms;
  config::eachChangedNumber(settings.options, [&](const char* name, double value) {
    terms << QString::fromLatin1(name) + QLatin1Char('=') + argumentOf(value);
  });
  return terms;
}

ui::SpeedRow speedRowOf(const QJsonObject& json) {
  ui::SpeedRow row;
  row.t0 = numberIn(json, "t0", kTune);
  row.t1 = numberIn(json, "t1", kTune);
  row.scale = numberIn(json, "speed_scale", kTune);
  row.by_separation = numberIn(json, "by_separation", kTune);
  row.by_contact = numberIn(json, "by_contact", kTune);
  const QJsonValue limit = json.value(QLatin1String("limited_by"));
  if (!limit.isObject()) return row;
  row.limited = true;
  row.t = numberIn(limit.toObject(), "t", kTune);
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
  proposal.recorded = numberIn(times, "as_recorded", kTune);
  proposal.permitted =
      times.value(QLatin1String("permitted")).isNull() ? kInfinity : numberIn(times, "permitted", kTune);
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
      call_(work, packages),
      request_(std::move(request)),
      separation_(separationTerms(work.separation)),
      process_(std::move(program), {kSpeedsDone, kSpeedsNotProven, kSpeedsPartlyDone}) {
  if (work.separation.clamped)
    for (const std::string_view part : humanmodel::partNames())
      clamped_ << QString::fromUtf8(part.data(), static_cast<int>(part.size()));
  connect(&process_, &TuneProcess::answered, this, &SpeedJob::end);
  connect(&process_, &TuneProcess::failed, this, &SpeedJob::failed);
}

void SpeedJob::start() {
  process_.start([this] {
    QStringList words = call_.words();
    words << QStringLiteral("--json") << QStringLiteral("--speed-rule") << request_.rule
          << QStringLiteral("--segment") << argumentOf(request_.segment);
    if (!separation_.isEmpty()) words << QStringLiteral("--separation") << separation_;
    if (!clamped_.isEmpty()) words << QStringLiteral("--clamped") << clamped_;
    if (!request_.folder.isEmpty()) words << QStringLiteral("--speed-profile") << request_.folder;
    return words;
  });
}

void SpeedJob::end(const QByteArray& output, const QString& said) {
  try {
    Q_EMIT done(speedsOf(output, said));
  } catch (const std::exception& e) {
    Q_EMIT failed(QString::fromUtf8(e.what()));
  }
}

}  // namespace abstand::studio
