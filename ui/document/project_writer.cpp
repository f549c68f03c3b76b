// Writes project files.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "ui/document/json_text.hpp"
#include "ui/document/project_file.hpp"
#include "ui/document/project_names.hpp"

namespace abstand::ui {

namespace {

std::string fileName(const QString& file, const QString& folder) {
  return (folder.isEmpty() ? file : QDir(folder).relativeFilePath(file)).toStdString();
}

void addCamera(JsonText& json, const CameraView& camera) {
  json.open("camera", '{');
  json.open("focus", '[');
  for (const double x : camera.focus) json.addNumber("", x);
  json.close();
  json.addNumber("distance", camera.distance);
  json.addNumber("azimuth", camera.azimuth);
  json.addNumber("elevation", camera.elevation);
  json.close();
}

void addReading(JsonText& json, const ReadingOptions& reading, const QString& folder) {
  json.open("reading", '{');
  if (!reading.units.isEmpty()) json.addText("units", reading.units.toStdString());
  if (!reading.up.isEmpty()) json.addText("up", reading.up.toStdString());
  if (!reading.mirror.isEmpty()) json.addText("mirror", reading.mirror.toStdString());
  if (!reading.joint_map.isEmpty()) json.addText("joint_map", fileName(reading.joint_map, folder));
  json.addNumber("speed", reading.speed);
  json.addFlag("cut_things", reading.cut_things);
  json.close();
}

void addNames(JsonText& json, const char* key, const QSet<QString>& names) {
  json.open(key, '[');
  QStringList sorted = names.values();
  std::sort(sorted.begin(), sorted.end());
  for (const QString& name : sorted) json.addText("", name.toStdString());
  json.close();
}

void addMargins(JsonText& json, const char* key, const QMap<QString, double>& margins) {
  json.open(key, '{');
  for (auto it = margins.begin(); it != margins.end(); ++it)
    json.addNumber(it.key().toStdString(), it.value());
  json.close();
}

void addClasses(JsonText& json, const QMap<QString, ClassMargin>& classes) {
  if (classes.isEmpty()) return;
  json.open("classes", '{');
  for (auto it = classes.begin(); it != classes.end(); ++it) {
    json.open(it.key().toStdString(), '{');
    json.addNumber("margin", it->metres);
    if (it->locked) json.addFlag("locked", true);
    json.close();
  }
  json.close();
}

void addPeople(JsonText& json, const QMap<QString, PersonOptions>& people) {
  if (people.isEmpty()) return;
  json.open("people", '{');
  for (auto it = people.begin(); it != people.end(); ++it) {
    json.open(it.key().toStdString(), '{');
    if (it->stature) json.addNumber("stature", *it->stature);
    if (it->percentile) json.addNumber("percentile", *it->percentile);
    if (it->mass) json.addNumber("mass", *it->mass);
    if (!it->sex.isEmpty()) json.addText("sex", it->sex.toStdString());
    json.close();
  }
  json.close();
}

void addPlacements(JsonText& json, const char* key, const QMap<QString, Placement>& placements) {
  if (placements.isEmpty()) return;
  json.open(key, '{');
  for (auto it = placements.begin(); it != placements.end(); ++it) {
    json.open(it.key().toStdString(), '{');
    for (const auto& [name, numbers] : {std::pair("xyz", it->xyz), std::pair("rpy", it->rpy)}) {
      json.open(name, '[');
      for (const double number : numbers) json.addNumber("", number);
      json.close();
    }
    json.close();
  }
  json.close();
}

void addFiles(JsonText& json, const char* key, const QStringList& files, const QString& folder) {
  if (files.isEmpty()) return;
  json.open(key, '[');
  for (const QString& file : files) json.addText("", fileName(file, folder));
  json.close();
}

void addPosed(JsonText& json, const QMap<QString, QVector<double>>& posed) {
  if (posed.isEmpty()) return;
  json.open("posed_robots", '{');
  for (auto it = posed.begin(); it != posed.end(); ++it) {
    json.open(it.key().toStdString(), '[');
    for (const double q : *it) json.addNumber("", q);
    json.close();
  }
  json.close();
}

void addLawNumber(JsonText& json, std::string_view name, double value) {
  if (std::isfinite(value))
    json.addNumber(name, value);
  else
    json.addText(name, value > 0.0 ? kUnlimited : kUnlimitedBelow);
}

void addReactions(JsonText& json, const QMap<QString, control::ReactionChange>& reactions) {
  if (reactions.isEmpty()) return;
  json.open("reactions", '{');
  for (auto it = reactions.begin(); it != reactions.end(); ++it) {
    json.open(it.key().toStdString(), '{');
    json.open("laws", '{');
    for (const auto& [law, on] : it->laws) json.addFlag(law, on);
    json.close();
    json.open("numbers", '{');
    for (const auto& [key, numbers] : it->numbers) {
      if (numbers.size() == 1) {
        addLawNumber(json, key, numbers.front());
        continue;
      }
      json.open(key, '[');
      for (const double number : numbers) addLawNumber(json, "", number);
      json.close();
    }
    json.close();
    if (!it->responses.empty()) {
      json.open("responses", '{');
      for (const auto& [reason, response] : it->responses)
        json.addText(reason, std::string(safety::responseName(response)));
      json.close();
    }
    json.close();
  }
  json.close();
}

void addPairs(JsonText& json, const Work& work) {
  json.open("pair_groups", '{');
  for (auto it = work.groups.begin(); it != work.groups.end(); ++it)
    json.addText(it.key().toStdString(), kGroupStates[static_cast<std::size_t>(it.value())]);
  json.close();
  json.open("moved_pairs", '[');
  for (auto it = work.moved.begin(); it != work.moved.end(); ++it) {
    json.open("", '{');
    json.addText("a", it.key().first.toStdString());
    json.addText("b", it.key().second.toStdString());
    if (!it.value().isEmpty()) json.addText("group", it.value().toStdString());
    json.close();
  }
  json.close();
  if (work.added.isEmpty()) return;
  json.open("added_pairs", '[');
  QList<QPair<QString, QString>> sorted = work.added.values();
  std::sort(sorted.begin(), sorted.end());
  for (const auto& pair : sorted) {
    json.open("", '{');
    json.addText("a", pair.first.toStdString());
    json.addText("b", pair.second.toStdString());
    json.close();
  }
  json.close();
}

void addTimes(JsonText& json, const Work& work) {
  json.open("bookmarks", '[');
  for (const Bookmark& mark : work.bookmarks) {
    json.open("", '{');
    json.addNumber("time", mark.t);
    if (!mark.note.isEmpty()) json.addText("note", mark.note.toStdString());
    if (mark.camera) addCamera(json, *mark.camera);
    json.close();
  }
  json.close();
  if (!work.range) return;
  json.open("range", '{');
  json.addNumber("in", work.range->from);
  json.addNumber("out", work.range->to);
  json.close();
}

/// What differs from the usual.
void addSeparation(JsonText& json, const SeparationSettings& separation) {
  const SeparationSettings usual;
  if (separation == usual) return;
  json.open("separation", '{');
  config::eachChangedNumber(separation.options,
                            [&](const char* name, double value) { json.addNumber(name, value); });
  if (separation.robot_mass != usual.robot_mass) json.addNumber("robot_mass", separation.robot_mass);
  if (separation.clamped) json.addFlag("clamped", true);
  json.close();
}

/// What differs from the usual.
void addWhatIf(JsonText& json, const WhatIfSettings& what_if) {
  if (what_if == WhatIfSettings()) return;
  json.open("what_if", '{');
  config::eachChangedNumber(what_if, [&](const char* name, double value) { json.addNumber(name, value); });
  json.close();
}

void addLens(JsonText& json, const SensorLens& lens) {
  json.open("lens", '{');
  json.addText("name", lens.name.toStdString());
  json.addNumber("width", lens.width);
  json.addNumber("height", lens.height);
  json.addNumber("fx", lens.fx);
  json.addNumber("fy", lens.fy);
  json.addNumber("cx", lens.cx);
  json.addNumber("cy", lens.cy);
  json.addNumber("nearest", lens.nearest);
  json.addNumber("farthest", lens.farthest);
  json.close();
}

void addSensor(JsonText& json, const std::optional<SensorPlan>& sensor) {
  if (!sensor) return;
  json.open("planned_sensor", '{');
  json.addText("sensor", sensor->sensor.toStdString());
  if (sensor->lens) addLens(json, *sensor->lens);
  json.open("xyz", '[');
  for (const double number : sensor->xyz) json.addNumber("", number);
  json.close();
  json.addNumber("azimuth", sensor->azimuth);
  json.addNumber("elevation", sensor->elevation);
  json.addNumber("roll", sensor->roll);
  json.close();
}

void addView(JsonText& json, const ViewOptions& view) {
  json.open("view", '{');
  for (const ViewFlag& flag : kViewFlags) json.addFlag(flag.name, view.*flag.member);
  json.addNumber("people_opacity", view.human_opacity);
  for (const ViewNumber& number : kViewNumbers)
    if (view.*number.member != ViewOptions().*number.member) json.addNumber(number.name, view.*number.member);
  json.close();
}

}  // namespace

std::string projectText(const Project& project, const QString& folder, const QString& saved_as) {
  const Work& work = project.work;
  JsonText json;
  json.open("", '{');
  json.add(kVersionKey, std::to_string(kProjectVersion));
  if (!saved_as.isEmpty()) json.addText("saved_as", fileName(saved_as, folder));
  if (!work.scene.isEmpty()) json.addText("scene", fileName(work.scene, folder));
  if (!work.recording.isEmpty()) json.addText("recording", fileName(work.recording, folder));
  addFiles(json, "recordings", work.recordings, folder);
  addFiles(json, "added_files", work.added_files, folder);
  addReading(json, work.reading, folder);
  addPeople(json, work.people);
  addPlacements(json, "placed", work.placed);
  addPlacements(json, "things", work.things);
  addPosed(json, work.posed);
  addReactions(json, work.reactions);
  addMargins(json, "margins", work.margins);
  addClasses(json, work.classes);
  if (!work.locked.isEmpty()) addNames(json, "locked_margins", work.locked);
  if (work.compared) addMargins(json, "compared_margins", *work.compared);
  addPairs(json, work);
  addNames(json, "hidden", work.hidden);
  addTimes(json, work);
  addSeparation(json, work.separation);
  addWhatIf(json, work.what_if);
  addSensor(json, work.sensor);
  addView(json, work.view);
  if (project.viewpoint.camera) addCamera(json, *project.viewpoint.camera);
  json.addNumber("time", project.viewpoint.t);
  if (!project.viewpoint.layout.isEmpty())
    json.addText("layout", project.viewpoint.layout.toBase64().toStdString());
  json.close();
  return json.text();
}

void writeProject(const Project& project, const QString& file) {
  const QString folder = QFileInfo(file).absolutePath();
  const std::string text = projectText(project, folder);
  try {
    parseProject(text, file, folder);
  } catch (const ParseError& e) {
    throw UsageError(file.toStdString() + ": cannot be saved: " + e.message());
  }
  writeFile(QFile::encodeName(file).toStdString(), text);
}

}  // namespace abstand::ui
