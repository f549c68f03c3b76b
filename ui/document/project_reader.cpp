// Reads project files, which may be damaged or come from strangers.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

#include "core/base/text_file.hpp"
#include "core/config/yaml_reader.hpp"
#include "ui/document/project_file.hpp"
#include "ui/document/project_names.hpp"

namespace abstand::ui {

namespace {

using config::YamlFields;
using config::YamlNode;
using config::YamlRange;

constexpr YamlRange kTime{-1e9, 1e9, "s"};
constexpr YamlRange kLength{-1e6, 1e6, "m"};
constexpr YamlRange kDistance{0.0, 1e6, "m", true};
constexpr YamlRange kFocalLength{0.0, 1e6, "pixels", true};
constexpr YamlRange kImageCentre{-1e6, 1e6, "pixels"};
constexpr YamlRange kAngle{-1e6, 1e6, "rad"};
constexpr YamlRange kMargin{0.0, kMaxMargin, "m"};
constexpr YamlRange kSpeed{0.0, 1e3, "", true};
constexpr YamlRange kOpacity{0.0, 1.0};
constexpr YamlRange kStature{0.5, 2.5, "m"};
constexpr YamlRange kPercentile{1.0, 99.0, "%"};
constexpr YamlRange kMass{10.0, 300.0, "kg"};
constexpr YamlRange kRobotMass{0.0, 1e4, "kg"};
constexpr YamlRange kArrowNumber{0.0, 1e4, "SI units"};
constexpr YamlRange kJoint{-1e4, 1e4, "rad or m"};

constexpr int kMaxLayoutBytes = 1 << 16;

[[noreturn]] void fail(const YamlFields& in, const YamlNode& node, const std::string& expected) {
  throw ParseError(in.pos(node), "found " + config::yamlFound(node) + ", expected " + expected);
}

/// The map under a key with keys that the reader does not know beforehand; null when absent.
const YamlNode* namesOf(const YamlFields& in, std::string_view key) {
  const YamlNode* node = in.find(key);
  if (node && node->kind != YamlNode::Kind::kMap) fail(in, *node, "a map");
  return node;
}

QString textOf(const YamlFields& in, std::string_view key) {
  return QString::fromStdString(in.text(key).value_or(""));
}

QString pathOf(const YamlFields& in, std::string_view key, const QString& folder) {
  const QString path = textOf(in, key);
  return path.isEmpty() ? path : QDir::cleanPath(QDir(folder).absoluteFilePath(path));
}

bool flagOf(const YamlFields& in, std::string_view key, bool standard) {
  const auto word = in.choice(key, {"true", "false"});
  return word ? *word == "true" : standard;
}

std::optional<CameraView> cameraOf(const YamlFields& in) {
  const YamlNode* node = in.find("camera");
  if (!node) return std::nullopt;
  const YamlFields fields(*node, in.file(), "a camera", {"focus", "distance", "azimuth", "elevation"});
  CameraView camera;
  camera.focus = fields.vector("focus", kLength).value_or(camera.focus);
  camera.distance = fields.number("distance", kDistance).value_or(camera.distance);
  camera.azimuth = fields.number("azimuth", kAngle).value_or(camera.azimuth);
  camera.elevation = fields.number("elevation", kAngle).value_or(camera.elevation);
  return camera;
}

/// As QMainWindow::saveState() gave it.
QByteArray layoutOf(const YamlFields& in) {
  const YamlNode* node = in.find("layout");
  if (!node) return {};
  const QByteArray text = QByteArray::fromStdString(in.text("layout").value_or(""));
  const auto decoded = QByteArray::fromBase64Encoding(text, QByteArray::AbortOnBase64DecodingErrors);
  if (!decoded || decoded.decoded.isEmpty() || decoded.decoded.size() > kMaxLayoutBytes)
    fail(in, *node, "the layout of the panels in base64");
  return decoded.decoded;
}

void readReading(const YamlFields& in, const QString& folder, ReadingOptions& reading) {
  const YamlNode* node = in.find("reading");
  if (!node) return;
  const YamlFields fields(*node, in.file(), "`reading`",
                          {"units", "up", "mirror", "joint_map", "speed", "cut_things"});
  reading.units = textOf(fields, "units");
  reading.up = textOf(fields, "up");
  reading.mirror = textOf(fields, "mirror");
  reading.joint_map = pathOf(fields, "joint_map", folder);
  reading.speed = fields.number("speed", kSpeed).value_or(reading.speed);
  reading.cut_things = flagOf(fields, "cut_things", reading.cut_things);
}

void readPeople(const YamlFields& in, Work& work) {
  const YamlNode* node = namesOf(in, "people");
  for (std::size_t i = 0; node && i < node->keys.size(); ++i) {
    const YamlFields fields(node->items[i], in.file(), "a person", {"stature", "percentile", "mass", "sex"});
    PersonOptions person;
    person.stature = fields.number("stature", kStature);
    person.percentile = fields.number("percentile", kPercentile);
    person.mass = fields.number("mass", kMass);
    if (const auto sex = fields.choice("sex", {"f", "m"})) person.sex = QString::fromStdString(*sex);
    if (!(person == PersonOptions())) work.people[QString::fromStdString(node->keys[i].text)] = person;
  }
}

QMap<QString, Placement> placementsUnder(const YamlFields& in, std::string_view key) {
  QMap<QString, Placement> placements;
  const YamlNode* node = namesOf(in, key);
  for (std::size_t i = 0; node && i < node->keys.size(); ++i) {
    const YamlFields fields(node->items[i], in.file(), "a placement", {"xyz", "rpy"});
    placements[QString::fromStdString(node->keys[i].text)] = {
        fields.vector("xyz", kLength).value_or(Vector3d::Zero()),
        fields.vector("rpy", kAngle).value_or(Vector3d::Zero())};
  }
  return placements;
}

/// Absolute paths.
QStringList filesUnder(const YamlFields& in, std::string_view key, const QString& folder) {
  QStringList files;
  for (const YamlNode& item : in.list(key))
    files << QDir::cleanPath(QDir(folder).absoluteFilePath(
        QString::fromStdString(config::yamlText(item, in.file(), "`" + std::string(key) + "`"))));
  return files;
}

void readPosed(const YamlFields& in, Work& work) {
  const YamlNode* node = namesOf(in, "posed_robots");
  for (std::size_t i = 0; node && i < node->keys.size(); ++i) {
    const std::string name = "`" + node->keys[i].text + "`";
    const YamlNode& list = node->items[i];
    if (list.kind != YamlNode::Kind::kList || list.items.empty())
      fail(in, list, "a list with the values of the joints");
    QVector<double>& joints = work.posed[QString::fromStdString(node->keys[i].text)];
    for (const YamlNode& item : list.items)
      joints.push_back(config::yamlNumber(item, in.file(), name, kJoint));
  }
}

double lawNumber(const YamlNode& node, const YamlFields& in, const std::string& label) {
  if (node.kind == YamlNode::Kind::kScalar && node.quoted) {
    const std::string word = config::yamlChoice(node, in.file(), label, {kUnlimited, kUnlimitedBelow});
    return word == kUnlimited ? kInfinity : -kInfinity;
  }
  return config::yamlNumber(node, in.file(), label, YamlRange{-kInfinity, kInfinity});
}

/// Whether the numbers fit the laws is checked where the scene is known.
void readReactions(const YamlFields& in, Work& work) {
  const YamlNode* node = namesOf(in, "reactions");
  for (std::size_t i = 0; node && i < node->keys.size(); ++i) {
    const YamlFields fields(node->items[i], in.file(), "a reaction", {"laws", "numbers", "responses"});
    control::ReactionChange change;
    const YamlNode* laws = namesOf(fields, "laws");
    for (std::size_t k = 0; laws && k < laws->keys.size(); ++k)
      change.laws[laws->keys[k].text] =
          config::yamlChoice(laws->items[k], in.file(), "`" + laws->keys[k].text + "`", {"true", "false"}) ==
          "true";
    const YamlNode* numbers = namesOf(fields, "numbers");
    for (std::size_t k = 0; numbers && k < numbers->keys.size(); ++k) {
      const std::string label = "`" + numbers->keys[k].text + "`";
      const YamlNode& value = numbers->items[k];
      config::JointNumbers& list = change.numbers[numbers->keys[k].text];
      if (value.kind != YamlNode::Kind::kList) {
        list = {lawNumber(value, fields, label)};
        continue;
      }
      if (value.items.empty()) fail(in, value, "a number, or one for each joint");
      for (const YamlNode& item : value.items) list.push_back(lawNumber(item, fields, label));
    }
    const YamlNode* responses = namesOf(fields, "responses");
    for (std::size_t k = 0; responses && k < responses->keys.size(); ++k)
      change.responses[responses->keys[k].text] = *safety::parseResponse(config::yamlChoice(
          responses->items[k], in.file(), "`" + responses->keys[k].text + "`", safety::responseNames()));
    if (!change.empty()) work.reactions[QString::fromStdString(node->keys[i].text)] = change;
  }
}

/// By object, m.
QMap<QString, double> marginsUnder(const YamlFields& in, std::string_view key) {
  QMap<QString, double> margins;
  const YamlNode* node = namesOf(in, key);
  for (std::size_t i = 0; node && i < node->keys.size(); ++i)
    margins[QString::fromStdString(node->keys[i].text)] =
        config::yamlNumber(node->items[i], in.file(), "`" + node->keys[i].text + "`", kMargin);
  return margins;
}

void readClasses(const YamlFields& in, Work& work) {
  const YamlNode* node = in.find("classes");
  if (!node) return;
  const std::vector<std::string> names(view::kPairClassNames.begin(), view::kPairClassNames.end());
  const YamlFields classes(*node, in.file(), "`classes`", names);
  for (const std::string& name : names) {
    const YamlNode* entry = classes.find(name);
    if (!entry) continue;
    const YamlFields fields(*entry, in.file(), "a class of pairs", {"margin", "locked"});
    fields.need("margin");
    work.classes[QString::fromStdString(name)] = {*fields.number("margin", kMargin),
                                                  flagOf(fields, "locked", false)};
  }
}

QSet<QString> namesUnder(const YamlFields& in, std::string_view key) {
  QSet<QString> names;
  for (const YamlNode& item : in.list(key))
    names.insert(QString::fromStdString(config::yamlText(item, in.file(), "`" + std::string(key) + "`")));
  return names;
}

void readPairs(const YamlFields& in, Work& work) {
  const YamlNode* node = namesOf(in, "pair_groups");
  for (std::size_t i = 0; node && i < node->keys.size(); ++i) {
    const std::string word =
        config::yamlChoice(node->items[i], in.file(), "`" + node->keys[i].text + "`", kGroupStates);
    const auto at = std::find(kGroupStates.begin(), kGroupStates.end(), word) - kGroupStates.begin();
    work.groups[QString::fromStdString(node->keys[i].text)] = static_cast<view::PairGroupState>(at);
  }
  for (const YamlNode& item : in.list("moved_pairs")) {
    const YamlFields pair(item, in.file(), "a pair", {"a", "b", "group"});
    pair.need("a");
    pair.need("b");
    work.moved[{textOf(pair, "a"), textOf(pair, "b")}] = textOf(pair, "group");
  }
  for (const YamlNode& item : in.list("added_pairs")) {
    const YamlFields pair(item, in.file(), "a pair", {"a", "b"});
    pair.need("a");
    pair.need("b");
    if (textOf(pair, "a") == textOf(pair, "b"))
      throw ParseError(pair.pos(), "found a pair of a body with itself, expected two different bodies");
    work.added.insert({textOf(pair, "a"), textOf(pair, "b")});
  }
}

void readTimes(const YamlFields& in, Work& work) {
  for (const YamlNode& item : in.list("bookmarks")) {
    const YamlFields fields(item, in.file(), "a bookmark", {"time", "note", "camera"});
    fields.need("time");
    work.bookmarks.push_back({*fields.number("time", kTime), textOf(fields, "note"), cameraOf(fields)});
  }
  std::stable_sort(work.bookmarks.begin(), work.bookmarks.end(),
                   [](const Bookmark& a, const Bookmark& b) { return a.t < b.t; });
  const YamlNode* node = in.find("range");
  if (!node) return;
  const YamlFields fields(*node, in.file(), "`range`", {"in", "out"});
  fields.need("in");
  fields.need("out");
  const TimeRange range{*fields.number("in", kTime), *fields.number("out", kTime)};
  if (range.from > range.to) throw ParseError(fields.pos(), "found `in` after `out`, expected it before");
  work.range = range;
}

void readSeparation(const YamlFields& in, SeparationSettings& separation) {
  const YamlNode* node = in.find("separation");
  if (!node) return;
  std::vector<std::string> known{"robot_mass", "clamped"};
  safety::SeparationOptions::eachNumber(
      separation.options, [&](const char* name, double, const auto&) { known.emplace_back(name); });
  const YamlFields fields(*node, in.file(), "`separation`", known);
  safety::SeparationOptions::eachNumber(
      separation.options, [&](const char* name, double& value, const config::NumberRule& rule) {
        value = fields.number(name, YamlRange{rule.min, rule.max, rule.unit, rule.above}).value_or(value);
      });
  separation.robot_mass = fields.number("robot_mass", kRobotMass).value_or(separation.robot_mass);
  separation.clamped = flagOf(fields, "clamped", separation.clamped);
}

void readWhatIf(const YamlFields& in, WhatIfSettings& what_if) {
  const YamlNode* node = in.find("what_if");
  if (!node) return;
  std::vector<std::string> known;
  WhatIfSettings::eachNumber(what_if,
                             [&](const char* name, double, const auto&) { known.emplace_back(name); });
  const YamlFields fields(*node, in.file(), "`what_if`", known);
  WhatIfSettings::eachNumber(what_if, [&](const char* name, double& value, const config::NumberRule& rule) {
    value = fields.number(name, YamlRange{rule.min, rule.max, rule.unit, rule.above}).value_or(value);
  });
}

SensorLens lensOf(const YamlFields& in, const YamlNode& node) {
  const YamlFields fields(node, in.file(), "a lens",
                          {"name", "width", "height", "fx", "fy", "cx", "cy", "nearest", "farthest"});
  SensorLens lens;
  fields.need("name");
  lens.name = textOf(fields, "name");
  for (const auto& [key, pixels] : {std::pair{"width", &lens.width}, {"height", &lens.height}})
    *pixels = fields.integer(key, 1, SensorLens::kMaxPixels).value_or(*pixels);
  for (const auto& [key, value] : {std::pair{"fx", &lens.fx}, {"fy", &lens.fy}})
    *value = fields.number(key, kFocalLength).value_or(*value);
  for (const auto& [key, value] : {std::pair{"cx", &lens.cx}, {"cy", &lens.cy}})
    *value = fields.number(key, kImageCentre).value_or(*value);
  for (const auto& [key, value] : {std::pair{"nearest", &lens.nearest}, {"farthest", &lens.farthest}})
    *value = fields.number(key, kDistance).value_or(*value);
  return lens;
}

void readSensor(const YamlFields& in, Work& work) {
  const YamlNode* node = in.find("planned_sensor");
  if (!node) return;
  const YamlFields fields(*node, in.file(), "a planned sensor",
                          {"sensor", "lens", "xyz", "azimuth", "elevation", "roll"});
  SensorPlan plan;
  fields.need("sensor");
  plan.sensor = textOf(fields, "sensor");
  if (const YamlNode* lens = fields.find("lens")) plan.lens = lensOf(fields, *lens);
  plan.xyz = fields.vector("xyz", kLength).value_or(plan.xyz);
  plan.azimuth = fields.number("azimuth", kAngle).value_or(plan.azimuth);
  plan.elevation = fields.number("elevation", kAngle).value_or(plan.elevation);
  plan.roll = fields.number("roll", kAngle).value_or(plan.roll);
  work.sensor = plan;
}

void readView(const YamlFields& in, ViewOptions& view) {
  const YamlNode* node = in.find("view");
  if (!node) return;
  std::vector<std::string> known{"people_opacity"};
  for (const ViewFlag& flag : kViewFlags) known.emplace_back(flag.name);
  for (const ViewNumber& number : kViewNumbers) known.emplace_back(number.name);
  const YamlFields fields(*node, in.file(), "`view`", known);
  for (const ViewFlag& flag : kViewFlags) view.*flag.member = flagOf(fields, flag.name, view.*flag.member);
  view.human_opacity = fields.number("people_opacity", kOpacity).value_or(view.human_opacity);
  for (const ViewNumber& number : kViewNumbers)
    view.*number.member = fields.number(number.name, kArrowNumber).value_or(view.*number.member);
}

}  // namespace

ProjectFile parseProject(const std::string& text, const QString& file, const QString& folder) {
  const std::string name = file.toStdString();
  const YamlNode root = config::parseYaml(text, name);
  const YamlFields in(root, name, "a project",
                      {kVersionKey,   "saved_as",     "scene",       "recording",      "reading",
                       "people",      "posed_robots", "margins",     "locked_margins", "compared_margins",
                       "pair_groups", "moved_pairs",  "added_pairs", "hidden",         "bookmarks",
                       "range",       "separation",   "view",        "camera",         "time",
                       "reactions",   "added_files",  "what_if",     "classes",        "placed",
                       "things",      "recordings",   "layout",      "planned_sensor"});
  const YamlNode& version = in.need(kVersionKey);
  if (version.text != std::to_string(kProjectVersion))
    fail(in, version, "version " + std::to_string(kProjectVersion) + " of project files");
  ProjectFile out;
  Work& work = out.project.work;
  out.saved_as = pathOf(in, "saved_as", folder);
  work.scene = pathOf(in, "scene", folder);
  work.recording = pathOf(in, "recording", folder);
  work.recordings = filesUnder(in, "recordings", folder);
  work.added_files = filesUnder(in, "added_files", folder);
  readReading(in, folder, work.reading);
  readPeople(in, work);
  work.placed = placementsUnder(in, "placed");
  work.things = placementsUnder(in, "things");
  readPosed(in, work);
  readReactions(in, work);
  work.margins = marginsUnder(in, "margins");
  readClasses(in, work);
  work.locked = namesUnder(in, "locked_margins");
  if (in.find("compared_margins")) work.compared = marginsUnder(in, "compared_margins");
  readPairs(in, work);
  work.hidden = namesUnder(in, "hidden");
  readTimes(in, work);
  readSeparation(in, work.separation);
  readWhatIf(in, work.what_if);
  readSensor(in, work);
  readView(in, work.view);
  out.project.viewpoint = {cameraOf(in), in.number("time", kTime).value_or(0.0), layoutOf(in)};
  return out;
}

Project readProject(const QString& file) {
  const std::string text = readFile(QFile::encodeName(file).toStdString(), config::kMaxYamlBytes);
  return parseProject(text, file, QFileInfo(file).absolutePath()).project;
}

}  // namespace abstand::ui
