#include "app/studio/scene_of_file.hpp"

#include <QFile>
#include <QFileInfo>

namespace abstand::studio {

namespace {

/// In the quotes of YAML.
std::string quoted(const QString& text) {
  QString safe = text;
  safe.replace(QLatin1Char('\\'), QLatin1String("\\\\")).replace(QLatin1Char('"'), QLatin1String("\\\""));
  return '"' + safe.toStdString() + '"';
}

}  // namespace

scene_file::SceneDescription sceneOf(const QString& file, const QString& recording,
                                     const robot_file::PackagePaths& packages) {
  const QString path = QFileInfo(file.isEmpty() ? recording : file).absoluteFilePath();
  const std::filesystem::path name(QFile::encodeName(path).toStdString());
  if (file.isEmpty() && QFileInfo(path).isDir()) {
    // Of depth images; a scene file names files only.
    scene_file::SceneDescription scene =
        scene_file::parseScene("abstand: 1\nhumans:\n  - {name: person}\n", name, packages);
    scene.humans[0].recording.file = name;
    return scene;
  }
  if (file.isEmpty())
    return scene_file::parseScene(
        "abstand: 1\nhumans:\n  - {name: person, recording: {file: " + quoted(path) + "}}\n", name, packages);
  const QString ending = QFileInfo(file).suffix().toLower();
  if (ending == QLatin1String("urdf") || ending == QLatin1String("mech"))
    return scene_file::parseScene("abstand: 1\nmechanisms:\n  - {name: robot, file: " + quoted(path) + "}\n",
                                  name, packages);
  return scene_file::loadScene(QFile::encodeName(file).toStdString(), packages);
}

}  // namespace abstand::studio
