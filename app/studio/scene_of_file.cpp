#include "app/studio/scene_of_file.hpp"

#include <QFile>
#include <QFileInfo>
#include <set>
#include <sstream>

#include "core/geometry/triangle_mesh.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "ui/style/file_kinds.hpp"

namespace abstand::studio {

namespace {

using scene_file::SceneDescription;

constexpr double kMillimetre = 1e-3;
constexpr char kPersonText[] = "abstand: 1\nhumans:\n  - {name: person}\n";

std::filesystem::path pathOf(const QString& file) { return QFile::encodeName(file).toStdString(); }

/// Letters and digits of the file's name, which is free to be used as the name of a body.
std::string nameFor(const QString& file, std::set<std::string>& taken) {
  QString stem;
  for (const QChar c : QFileInfo(file).completeBaseName())
    stem += c.isLetterOrNumber() || c == QLatin1Char('_') || c == QLatin1Char('-') ? c : QLatin1Char('_');
  if (stem.isEmpty()) stem = QStringLiteral("thing");
  std::string name = stem.toStdString();
  for (int i = 2; !taken.insert(name).second; ++i) name = stem.toStdString() + "_" + std::to_string(i);
  return name;
}

std::set<std::string> bodyNamesOf(const SceneDescription& scene) {
  std::set<std::string> names;
  for (const auto& mechanism : scene.mechanisms) names.insert(mechanism.name);
  for (const auto& human : scene.humans) names.insert(human.name);
  for (const auto& object : scene.objects) names.insert(object.name);
  return names;
}

SceneDescription robotAlone(const QString& file, const std::string& name,
                            const robot_file::PackagePaths& packages) {
  const QString path = QFileInfo(file).absoluteFilePath();
  return scene_file::parseScene("abstand: 1\nmechanisms:\n  - {name: " +
                                    quoted(QString::fromStdString(name)) + ", file: " + quoted(path) + "}\n",
                                pathOf(path), packages);
}

void addMesh(const QString& file, SceneDescription& scene, std::set<std::string>& taken) {
  scene_file::ObjectDescription thing;
  thing.mesh = pathOf(QFileInfo(file).absoluteFilePath());
  const geometry::TriangleMesh mesh = mesh_file::loadMesh(thing.mesh).mesh;
  const double extent = geometry::bounds(mesh).extent().maxCoeff();
  if (extent > kLargestThing) {
    thing.scale *= kMillimetre;
    std::ostringstream remark;
    remark << thing.mesh.string() << ": found an extent of " << extent
           << ", so its lengths are taken to be millimetres";
    scene.remarks.push_back(remark.str());
  }
  thing.name = nameFor(file, taken);
  thing.pos.file = thing.mesh.string();
  scene.objects.push_back(std::move(thing));
}

void addRobot(const QString& file, const robot_file::PackagePaths& packages, SceneDescription& scene,
              std::set<std::string>& taken) {
  SceneDescription robot = robotAlone(file, nameFor(file, taken), packages);
  scene.mechanisms.push_back(std::move(robot.mechanisms.front()));
  scene.pairs.dropped.insert(scene.pairs.dropped.end(), robot.pairs.dropped.begin(),
                             robot.pairs.dropped.end());
  scene.remarks.insert(scene.remarks.end(), robot.remarks.begin(), robot.remarks.end());
}

/// Without a scene file, messages and the title go by the first file that there is.
SceneDescription baseOf(const ui::Work& work, const robot_file::PackagePaths& packages) {
  if (hasSceneFile(work)) return scene_file::loadScene(pathOf(work.scene), packages);
  if (!work.scene.isEmpty()) return robotAlone(work.scene, "robot", packages);
  const QString name = work.recording.isEmpty() ? work.added_files.value(0) : work.recording;
  return scene_file::parseScene("abstand: 1\n", pathOf(QFileInfo(name).absoluteFilePath()), packages);
}

}  // namespace

bool hasSceneFile(const ui::Work& work) {
  return !work.scene.isEmpty() && ui::kindOf(work.scene) != ui::FileKind::kRobot;
}

std::string quoted(const QString& text) {
  QString safe = text;
  safe.replace(QLatin1Char('\\'), QLatin1String("\\\\")).replace(QLatin1Char('"'), QLatin1String("\\\""));
  return '"' + safe.toStdString() + '"';
}

SceneDescription sceneOf(const ui::Work& work, const robot_file::PackagePaths& packages) {
  SceneDescription scene = baseOf(work, packages);
  if (!work.recording.isEmpty() && !hasSceneFile(work)) {
    const QString path = QFileInfo(work.recording).absoluteFilePath();
    scene.humans = scene_file::parseScene(kPersonText, scene.file, packages).humans;
    scene.humans[0].recording.file = pathOf(path);
    scene.humans[0].recording.pos.file = path.toStdString();
  }
  std::set<std::string> taken = bodyNamesOf(scene);
  for (const QString& file : work.added_files)
    if (ui::kindOf(file) == ui::FileKind::kMesh)
      addMesh(file, scene, taken);
    else
      addRobot(file, packages, scene, taken);
  return scene;
}

bool isComposed(const ui::Work& work) { return !hasSceneFile(work) || !work.added_files.isEmpty(); }

}  // namespace abstand::studio
