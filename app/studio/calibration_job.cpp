#include "app/studio/calibration_job.hpp"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "app/studio/answer_number.hpp"
#include "humanmodel/part_uncertainty.hpp"

namespace abstand::studio {

namespace {

constexpr int kCalibrated = 0;
constexpr int kPoseNumbers = 12;  // of T_WC, row by row
constexpr const char* kCalibrate = "abstand calibrate";

struct FactKey {
  const char* key;
  ui::CalibrationFact::Kind kind;
  const char* where;  ///< key of a text or number; null: none
};
using FactKind = ui::CalibrationFact::Kind;
constexpr FactKey kFactKeys[] = {
    {"images", FactKind::kImages, nullptr},           {"points", FactKind::kPoints, nullptr},
    {"corners", FactKind::kPoints, nullptr},          {"used", FactKind::kPoints, nullptr},
    {"worst", FactKind::kWorst, "worst_line"},        {"worst_px", FactKind::kWorstPixels, "worst_image"},
    {"shared", FactKind::kShared, nullptr},           {"agreeing", FactKind::kAgreeing, nullptr},
    {"explained", FactKind::kExplained, nullptr},     {"moved", FactKind::kMoved, nullptr},
    {"turned", FactKind::kTurned, nullptr},           {"clock", FactKind::kClock, nullptr},
    {"person_moved", FactKind::kPersonMoved, nullptr}};

}  // namespace

ui::CalibrationAnswer calibrationOf(const QByteArray& json) {
  const QJsonObject document = QJsonDocument::fromJson(json).object();
  const QJsonArray pose = document.value(QLatin1String("T_WC")).toArray();
  if (pose.size() != kPoseNumbers)
    throw UsageError("found no pose in the answer of abstand calibrate, expected one with `T_WC`");
  ui::CalibrationAnswer answer;
  for (int i = 0; i < 3; ++i) answer.xyz[i] = pose[4 * i + 3].toDouble();
  answer.in_pixels = document.contains(QLatin1String("rms_px"));
  answer.residual = numberIn(document, answer.in_pixels ? "rms_px" : "rms", kCalibrate);
  answer.spread = numberIn(document, "spread", kCalibrate);
  answer.widening = humanmodel::kSpreadQuantile * answer.spread;
  for (const FactKey& fact : kFactKeys) {
    if (!document.contains(QLatin1String(fact.key))) continue;
    ui::CalibrationFact found{fact.kind, numberIn(document, fact.key, kCalibrate), {}};
    if (fact.where) {
      const QJsonValue where = document.value(QLatin1String(fact.where));
      found.where =
          where.isString() ? QFileInfo(where.toString()).fileName() : QString::number(where.toInt());
    }
    answer.facts.push_back(found);
  }
  for (const QJsonValue& warning : document.value(QLatin1String("warnings")).toArray())
    answer.warnings << warning.toString();
  return answer;
}

CalibrationJob::CalibrationJob(QString program, const ui::Work& work, ui::CalibrationRequest request,
                               const robot_file::PackagePaths& packages, QObject* parent)
    : QObject(parent),
      call_(work, packages),
      request_(std::move(request)),
      packages_(packages),
      process_(std::move(program), {kCalibrated}) {
  connect(&process_, &TuneProcess::answered, this, [this](const QByteArray& output) { end(output); });
  connect(&process_, &TuneProcess::failed, this, &CalibrationJob::failed);
}

void CalibrationJob::start() {
  process_.start([this] { return words(); });
}

QStringList CalibrationJob::words() const {
  using Mode = ui::CalibrationMode;
  QStringList words{QStringLiteral("calibrate")};
  switch (request_.mode) {
    case Mode::kRoom:
      words << request_.clip << QStringLiteral("--room") << request_.reference;
      break;
    case Mode::kPerson:
      words << request_.clip << QStringLiteral("--person") << request_.reference;
      break;
    case Mode::kLinks:
      words << call_.sceneFile() << QStringLiteral("--links") << request_.clip << QStringLiteral("--robot")
            << request_.robot;
      for (const auto& folder : packages_.folders)
        words << QStringLiteral("--package-path") << QFile::decodeName(folder.c_str());
      break;
    case Mode::kChessboard: {
      QStringList board;
      for (const Vector3d& numbers : {request_.board_xyz, request_.board_rpy})
        for (const double number : numbers) board << argumentOf(number);
      words << QStringLiteral("--chessboard") << request_.images << QStringLiteral("--squares")
            << QStringLiteral("%1x%2").arg(request_.columns).arg(request_.rows) << QStringLiteral("--square")
            << argumentOf(request_.square) << QStringLiteral("--board=") + board.join(QLatin1Char(','));
      break;
    }
    case Mode::kPoints:
      words << request_.clip;
      break;
  }
  if (!request_.camera.isEmpty()) words << QStringLiteral("--camera") << request_.camera;
  if (!folder_.isValid()) throw UsageError(folder_.errorString().toStdString());
  return words << QStringLiteral("--out") << folder_.filePath(QStringLiteral("camera.yaml"))
               << QStringLiteral("--json") << QStringLiteral("--quiet");
}

void CalibrationJob::end(const QByteArray& output) {
  try {
    ui::CalibrationAnswer answer = calibrationOf(output);
    QFile file(folder_.filePath(QStringLiteral("camera.yaml")));
    if (!file.open(QIODevice::ReadOnly)) throw UsageError(file.errorString().toStdString());
    answer.camera = file.readAll();
    Q_EMIT done(answer);
  } catch (const std::exception& e) {
    Q_EMIT failed(QString::fromUtf8(e.what()));
  }
}

}  // namespace abstand::studio
