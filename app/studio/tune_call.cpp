#include "app/studio/tune_call.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/scene_file/scene_description.hpp"
#include "app/studio/answer_number.hpp"
#include "app/studio/scene_of_file.hpp"
#include "app/studio/scene_of_work.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::studio {

QString commandLineProgram() {
  const QFileInfo beside(QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("abstand")));
  return beside.isExecutable() ? beside.absoluteFilePath()
                               : QStandardPaths::findExecutable(QStringLiteral("abstand"));
}

TuneCall::TuneCall(ui::Work work, robot_file::PackagePaths packages)
    : work_(std::move(work)), packages_(std::move(packages)) {}

QString TuneCall::keep(const QString& name, const std::string& text) const {
  if (!folder_.isValid()) throw UsageError(folder_.errorString().toStdString());
  const QString file = folder_.filePath(name);
  writeFile(QFile::encodeName(file).toStdString(), text);
  return file;
}

QString TuneCall::sceneFile() const {
  if (!changesScene(work_) && !isComposed(work_) && !hasUnchecked(work_)) return work_.scene;
  scene_file::SceneDescription scene = sceneOf(work_, packages_);
  applyWork(work_, scene);
  placeThings(work_, scene);
  leaveOutUnchecked(work_, scene);
  const QString name = QFileInfo(QString::fromStdString(scene.file.string())).completeBaseName();
  return keep(name + QStringLiteral("_as_read.yaml"), scene_file::describeScene(scene));
}

QStringList TuneCall::words() const {
  const QString scene = sceneFile();
  QStringList words{QStringLiteral("tune")};
  if (work_.reading.speed == 1.0) {
    words << scene;
    if (!work_.recording.isEmpty()) words << QStringLiteral("--recordings") << work_.recording;
  } else {
    std::string plan = "abstand_plan: 1\nscenes: [" + quoted(scene) + "]\n";
    if (!work_.recording.isEmpty()) plan += "recordings: [" + quoted(work_.recording) + "]\n";
    plan += "speeds: [" + formatDouble(work_.reading.speed) + "]\n";
    words << keep(QStringLiteral("plan.yaml"), plan);
  }
  if (work_.reading.cut_things) words << QStringLiteral("--cut-things");
  config::eachChangedNumber(work_.what_if, [&](const char* name, double value) {
    words << QStringLiteral("--") + QString::fromLatin1(name).replace(QLatin1Char('_'), QLatin1Char('-'))
          << argumentOf(value);
  });
  for (const auto& folder : packages_.folders)
    words << QStringLiteral("--package-path") << QFile::decodeName(folder.c_str());
  return words << QStringLiteral("--quiet");
}

}  // namespace abstand::studio
