#include "app/studio/scene_of_work.hpp"

#include <QFile>
#include <algorithm>

#include "app/analysis/analysis_runner.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::studio {

void applyPerson(const ui::PersonOptions& options, humanmodel::HumanOptions& body) {
  if (options.stature) body.height = options.stature;
  if (options.percentile) body.percentile = options.percentile;
  if (options.mass) body.mass = options.mass;
  if (!options.sex.isEmpty())
    body.sex = options.sex == QLatin1String("f") ? humanmodel::Sex::kFemale : humanmodel::Sex::kMale;
}

namespace {

/// As Session names them.
QSet<QString> bodiesOf(const scene_file::SceneDescription& scene) {
  QSet<QString> names;
  for (const auto& mechanism : scene.mechanisms)
    for (const auto& link : mechanism.links) names.insert(QString::fromStdString(link.name));
  for (const auto& human : scene.humans) {
    for (const auto& tool : human.tools) names.insert(QString::fromStdString(tool.bodyName(human.name)));
    for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i)
      names.insert(QString::fromStdString(
          human.name + "/" + std::string(humanmodel::partName(static_cast<humanmodel::BodyPart>(i)))));
  }
  for (const auto& object : scene.objects) names.insert(QString::fromStdString(object.name));
  return names;
}

}  // namespace

void applyWork(const ui::Work& work, scene_file::SceneDescription& scene) {
  for (scene_file::MechanismDescription& robot : scene.mechanisms)
    if (const auto place = work.placed.find(QString::fromStdString(robot.name)); place != work.placed.end())
      robot.X_WB = place->X_W();
  for (scene_file::HumanDescription& human : scene.humans) {
    if (!work.reading.units.isEmpty()) human.recording.options.units = work.reading.units.toStdString();
    if (!work.reading.up.isEmpty()) human.recording.options.up = work.reading.up.toStdString();
    if (!work.reading.mirror.isEmpty()) human.recording.options.mirror = work.reading.mirror.toStdString();
    if (!work.reading.joint_map.isEmpty())
      human.recording.options.joint_map = QFile::encodeName(work.reading.joint_map).toStdString();
    applyPerson(work.people.value(QString::fromStdString(human.name)), human.body);
    if (const auto place = work.placed.find(QString::fromStdString(human.name)); place != work.placed.end()) {
      human.recording.place_xyz = place->xyz;
      human.recording.place_yaw = place->rpy.z();
    }
  }
  if (work.added.isEmpty()) return;
  const QSet<QString> bodies = bodiesOf(scene);
  for (const auto& [a, b] : work.added)
    if (a != b && bodies.contains(a) && bodies.contains(b))
      scene.pairs.include.emplace_back(a.toStdString(), b.toStdString());
}

void placeThings(const ui::Work& work, scene_file::SceneDescription& scene) {
  for (scene_file::ObjectDescription& thing : scene.objects)
    if (const auto place = work.things.find(QString::fromStdString(thing.name)); place != work.things.end())
      thing.X_WB = place->X_W();
}

void leaveOutUnchecked(const ui::Work& work, scene_file::SceneDescription& scene) {
  if (!hasUnchecked(work)) return;
  const QSet<QString> bodies = bodiesOf(scene);
  std::vector<std::pair<std::string, std::string>> unchecked;
  for (auto it = work.moved.begin(); it != work.moved.end(); ++it)
    if (it->isEmpty() && bodies.contains(it.key().first) && bodies.contains(it.key().second))
      unchecked.emplace_back(it.key().first.toStdString(), it.key().second.toStdString());
  analysis::leaveOut(unchecked, scene);
}

bool hasUnchecked(const ui::Work& work) {
  return std::any_of(work.moved.begin(), work.moved.end(),
                     [](const QString& group) { return group.isEmpty(); });
}

bool changesScene(const ui::Work& work) {
  return !work.reading.units.isEmpty() || !work.reading.up.isEmpty() || !work.reading.mirror.isEmpty() ||
         !work.reading.joint_map.isEmpty() || !work.people.isEmpty() || !work.added.isEmpty() ||
         !work.placed.isEmpty() || !work.things.isEmpty();
}

}  // namespace abstand::studio
