#include "app/studio/scene_of_work.hpp"

namespace abstand::studio {

namespace {

void applyPerson(const ui::PersonOptions& options, humanmodel::HumanOptions& body) {
  if (options.stature) body.height = options.stature;
  if (options.percentile) body.percentile = options.percentile;
  if (options.mass) body.mass = options.mass;
  if (!options.sex.isEmpty())
    body.sex = options.sex == QLatin1String("f") ? humanmodel::Sex::kFemale : humanmodel::Sex::kMale;
}

}  // namespace

void applyWork(const ui::Work& work, scene_file::SceneDescription& scene) {
  for (scene_file::HumanDescription& human : scene.humans) {
    if (!work.reading.units.isEmpty()) human.recording.options.units = work.reading.units.toStdString();
    if (!work.reading.up.isEmpty()) human.recording.options.up = work.reading.up.toStdString();
    applyPerson(work.people.value(QString::fromStdString(human.name)), human.body);
  }
}

bool changesScene(const ui::Work& work) {
  return !work.reading.units.isEmpty() || !work.reading.up.isEmpty() || !work.people.isEmpty();
}

}  // namespace abstand::studio
