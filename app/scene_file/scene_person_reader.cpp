#include "app/scene_file/body_fields.hpp"
#include "app/scene_file/scene_body_reader.hpp"
#include "app/scene_file/worn_reader.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::scene_file {
namespace {

constexpr config::YamlRange kHeightRange{0.5, 2.5, "m"};
constexpr config::YamlRange kMassRange{10.0, 300.0, "kg"};
constexpr config::YamlRange kPercentileRange{1.0, 99.0, "%"};
constexpr config::YamlRange kPartRange{0.0, 10.0, "m", true};
constexpr config::YamlRange kRateRange{0.0, 1e6, "Hz", true};

/// Throws ParseError at `pos` for an impossible person.
void checkPerson(const humanmodel::HumanOptions& body, const SourcePos& pos) {
  try {
    humanmodel::makeHuman(body);
  } catch (const UsageError& e) {
    throw ParseError(pos, e.what());
  }
}

}  // namespace

RecordingDescription SceneBodyReader::recording(const config::YamlNode& node) {
  const config::YamlFields fields(node, file_, "`recording`",
                                  {"file", "format", "units", "up", "rate", "mirror", "joint_map",
                                   "marker_set", "repair", "place", "cut_things"});
  RecordingDescription r;
  tracking::RecordingOptions& o = r.options;
  r.pos = fields.pos();
  r.file = existingRecording(fields.need("file"), {file_, folder_}, "`file`");
  o.format = fields.text("format").value_or(o.format);
  if (const auto* units = fields.find("units")) {
    if (units->kind == config::YamlNode::Kind::kScalar && parseDouble(units->text))
      config::yamlNumber(*units, file_, "`units`", kScaleRange);
    o.units = config::yamlText(*units, file_, "`units`");
  }
  o.up = fields.choice("up", {"auto", "x", "y", "z", "-x", "-y", "-z"}).value_or(o.up);
  o.rate = fields.number("rate", kRateRange).value_or(o.rate);
  o.mirror = fields.choice("mirror", {"none", "axes", "sides"}).value_or(o.mirror);
  if (const auto* map = fields.find("joint_map"))
    o.joint_map = existingFile(*map, "`joint_map`", "a joint map");
  if (const auto* set = fields.find("marker_set")) {
    o.marker_set = config::yamlText(*set, file_, "`marker_set`");
    if (o.marker_set != "auto" && o.marker_set != "none")
      o.marker_set = existingFile(*set, "`marker_set`", "auto, none or a marker set").string();
  }
  o.repair = fields.choice("repair", {"true", "false"}).value_or("true") == "true";
  if (const auto cut = fields.choice("cut_things", {"true", "false"})) r.cut_things = *cut == "true";
  if (const auto* place = fields.find("place")) {
    const config::YamlFields p(*place, file_, "`place`", {"xyz", "yaw"});
    r.place_xyz = p.vector("xyz", kPositionRange).value_or(r.place_xyz);
    r.place_yaw = p.number("yaw", kAngleRange).value_or(0.0);
  }
  return r;
}

void SceneBodyReader::readPart(const std::string& name, const config::YamlNode& node,
                               HumanDescription& h) const {
  const config::YamlFields fields(
      node, file_, "the part `" + name + "`",
      {"contour", "length", "breadth", "depth", "shape", "margin", "voxel", "point", "max_speed"});
  const humanmodel::BodyPart part = humanmodel::parsePart(name).value();
  humanmodel::PartOverride& sizes = h.body.overrides[part];
  sizes.length = fields.number("length", kPartRange);
  sizes.contour = fields.number("contour", kPartRange);
  sizes.breadth = fields.number("breadth", kPartRange);
  sizes.depth = fields.number("depth", kPartRange);
  sizes.shape = fields.choice("shape", {"ellipsoid", "cuboid"});
  h.parts[part] = readSettings(fields);
}

void SceneBodyReader::readWorn(const config::YamlFields& fields, HumanDescription& h) {
  if (const auto* clothing = fields.find("clothing")) h.body.clothing = readClothing(*clothing, file_);
  for (const config::YamlNode& node : fields.list("tools")) {
    ToolDescription tool = readTool(node, file_, finder());
    takeBody(tool.bodyName(h.name), tool.pos);
    h.tools.push_back(std::move(tool));
  }
}

HumanDescription SceneBodyReader::human(const config::YamlNode& node) {
  const config::YamlFields fields(
      node, file_, "a human",
      {"name", "height", "mass", "percentile", "sex", "preset", "lengths", "parts", "recording", "voxel",
       "point", "outer_layers", "margin", "max_speed", "clamped", "clothing", "tools"});
  HumanDescription h;
  h.pos = fields.pos();
  h.name = newName(fields, groups_, "group");
  const auto part_names = humanmodel::partNames();
  for (const std::string_view part : part_names) {
    std::string body = h.name + "/" + std::string(part);
    if (!body_names_.insert(body).second)
      throw ParseError(fields.pos(fields.need("name")),
                       "found the body `" + body + "` a second time, expected another name for the human");
    addBody(std::move(body), h.pos);
  }
  h.body.percentile = fields.number("percentile", kPercentileRange);
  h.body.height = fields.number("height", kHeightRange);
  if (!h.body.height && !h.body.percentile) h.body.height = humanmodel::kUsualStature;
  h.body.mass = fields.number("mass", kMassRange);
  if (const auto sex = fields.choice("sex", {"f", "m"}))
    h.body.sex = *sex == "f" ? humanmodel::Sex::kFemale : humanmodel::Sex::kMale;
  if (fields.choice("preset", {"anthropometric", "thesis"}) == "thesis")
    h.body.preset = humanmodel::HumanPreset::kThesis;
  if (const auto* percentile = fields.find("percentile")) checkPerson(h.body, fields.pos(*percentile));
  h.follow_lengths = fields.choice("lengths", {"model", "recording"}).value_or("model") == "recording";
  h.settings = readSettings(fields);
  if (const auto* parts = fields.find("parts")) {
    const config::YamlFields known(*parts, file_, "`parts`", {part_names.begin(), part_names.end()});
    for (std::size_t i = 0; i < parts->keys.size(); ++i) readPart(parts->keys[i].text, parts->items[i], h);
  }
  for (const config::YamlNode& name : fields.list("clamped")) {
    const std::string text = config::yamlText(name, file_, "`clamped`");
    const auto part = humanmodel::parsePart(text);
    if (!part)
      throw ParseError(
          fields.pos(name),
          "found `" + text + "` in `clamped`, expected parts of the body: hand_left, torso, ...");
    h.clamped.insert(*part);
  }
  readWorn(fields, h);
  if (const auto* node_recording = fields.find("recording")) h.recording = recording(*node_recording);
  return h;
}

}  // namespace abstand::scene_file
