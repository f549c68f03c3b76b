#include "app/scene_file/scene_body_reader.hpp"

#include <algorithm>
#include <map>
#include <system_error>

#include "app/scene_file/robot_links.hpp"
#include "core/base/number.hpp"
#include "core/control/reaction.hpp"
#include "core/control/reaction_reader.hpp"
#include "core/robot_file/srdf_file.hpp"

namespace abstand::scene_file {
namespace {

namespace fs = std::filesystem;

constexpr config::YamlRange kPositionRange{-1e4, 1e4, "m"};
constexpr config::YamlRange kAngleRange{-1e3, 1e3, "rad"};
constexpr config::YamlRange kJointRange{-1e6, 1e6};
constexpr config::YamlRange kScaleRange{0.0, 1e6, "", true};
constexpr config::YamlRange kStretchRange{-1e6, 1e6};
constexpr config::YamlRange kSizeRange{0.0, 1e3, "m", true};
constexpr config::YamlRange kCapsuleLengthRange{0.0, 1e3, "m"};
constexpr config::YamlRange kHeightRange{0.5, 2.5, "m"};
constexpr config::YamlRange kMassRange{10.0, 300.0, "kg"};
/// `key: true` or `key: false`; false where it is not there.
bool flag(const config::YamlFields& fields, const char* key) {
  return fields.choice(key, {"true", "false"}).value_or("false") == "true";
}

constexpr config::YamlRange kThingMassRange{0.0, 1e5, "kg", true};
constexpr config::YamlRange kPartRange{0.0, 10.0, "m", true};
constexpr config::YamlRange kRateRange{0.0, 1e6, "Hz", true};
constexpr config::YamlRange kSpeedRange{0.0, 1e4, "m/s"};

double needNumber(const config::YamlFields& fields, std::string_view key, const config::YamlRange& range) {
  fields.need(key);
  return *fields.number(key, range);
}

Vector3d needVector(const config::YamlFields& fields, std::string_view key, const config::YamlRange& range) {
  fields.need(key);
  return *fields.vector(key, range);
}

Transform pose(const config::YamlFields& parent, std::string_view key) {
  const auto* node = parent.find(key);
  if (!node) return Transform::Identity();
  const config::YamlFields fields(*node, parent.file(), "`" + std::string(key) + "`", {"xyz", "rpy"});
  return fromXyzRpy(fields.vector("xyz", kPositionRange).value_or(Vector3d::Zero()),
                    fields.vector("rpy", kAngleRange).value_or(Vector3d::Zero()));
}

/// One number, or one for each axis of the mesh.
Vector3d scale(const config::YamlFields& fields) {
  const auto* node = fields.find("scale");
  if (!node || node->kind != config::YamlNode::Kind::kList)
    return Vector3d::Constant(fields.number("scale", kScaleRange).value_or(1.0));
  const Vector3d s = *fields.vector("scale", kStretchRange);
  if ((s.array() == 0.0).any())
    throw ParseError(fields.pos(*node), "found 0 in `scale`, expected numbers other than 0");
  return s;
}

BodySettings settings(const config::YamlFields& fields) {
  BodySettings s;
  s.voxel = fields.number("voxel", kVoxelRange);
  s.point = fields.number("point", kVoxelRange);
  s.margin = fields.number("margin", kMarginRange);
  s.outer_layers = fields.integer("outer_layers", 0, kMaxOuterLayers);
  s.max_speed = fields.number("max_speed", kSpeedRange);
  return s;
}

geometry::Shape shape(const config::YamlNode& node, const std::string& file) {
  const config::YamlFields kinds(node, file, "`shape`",
                                 {"sphere", "ellipsoid", "cuboid", "cylinder", "capsule"});
  if (node.keys.size() != 1)
    throw ParseError(kinds.pos(),
                     "found " + std::to_string(node.keys.size()) + " shapes in `shape`, expected one",
                     "for example {sphere: {radius: 0.05}}");
  const std::string kind = node.keys.front().text;
  const auto fields = [&](std::vector<std::string> keys) {
    return config::YamlFields(node.items.front(), file, "`" + kind + "`", std::move(keys));
  };
  if (kind == "sphere") return geometry::Sphere{needNumber(fields({"radius"}), "radius", kSizeRange)};
  if (kind == "ellipsoid")
    return geometry::Ellipsoid{needVector(fields({"semi_axes"}), "semi_axes", kSizeRange)};
  if (kind == "cuboid") return geometry::Cuboid{needVector(fields({"size"}), "size", kSizeRange)};
  const auto round = fields({"radius", "length"});
  const double radius = needNumber(round, "radius", kSizeRange);
  if (kind == "cylinder") return geometry::Cylinder{radius, needNumber(round, "length", kSizeRange)};
  return geometry::Capsule{radius, needNumber(round, "length", kCapsuleLengthRange)};
}

HumanPartDescription humanPart(const config::YamlNode& node, const std::string& file,
                               const std::string& name) {
  const config::YamlFields fields(
      node, file, "the part `" + name + "`",
      {"contour", "length", "breadth", "depth", "shape", "margin", "voxel", "point", "max_speed"});
  HumanPartDescription part;
  const auto keep = [&](const char* key, const config::YamlRange& range) {
    if (const auto value = fields.number(key, range)) part.numbers[key] = *value;
  };
  for (const char* key : {"contour", "length", "breadth", "depth"}) keep(key, kPartRange);
  keep("margin", kMarginRange);
  keep("max_speed", kSpeedRange);
  for (const char* key : {"voxel", "point"}) keep(key, kVoxelRange);
  part.shape = fields.choice("shape", {"ellipsoid", "cuboid"});
  return part;
}

}  // namespace

const std::vector<std::string>& humanPartNames() {
  static const std::vector<std::string> names{"torso",        "head",          "biceps_left", "biceps_right",
                                              "forearm_left", "forearm_right", "hand_left",   "hand_right",
                                              "thigh_left",   "thigh_right",   "calf_left",   "calf_right",
                                              "foot_left",    "foot_right"};
  return names;
}

std::string SceneBodyReader::newName(const config::YamlFields& fields, std::set<std::string>& taken,
                                     const char* kind) {
  const config::YamlNode& node = fields.need("name");
  const std::string name = config::yamlText(node, file_, "`name`");
  if (name.find_first_of(",\"") != std::string::npos || name.front() == ' ' || name.back() == ' ')
    throw ParseError(fields.pos(node),
                     "found " + config::yamlFound(node) +
                         " for `name`, expected no comma, no quotation mark and no outer blanks",
                     "names stand in the headers of CSV files");
  if (!taken.insert(name).second)
    throw ParseError(
        fields.pos(node),
        "found the " + std::string(kind) + " name " + config::yamlFound(node) +
            " that is taken already, expected a new one",
        name == "objects" && &taken == &groups_ ? "`objects` is the group of all single objects" : "");
  return name;
}

void SceneBodyReader::addBody(std::string name, const SourcePos& pos) {
  if (bodies_.size() >= kMaxBodies)
    throw ParseError(pos, "found more than " + std::to_string(kMaxBodies) + " bodies, expected fewer");
  bodies_.push_back(std::move(name));
}

std::string SceneBodyReader::newBody(const config::YamlFields& fields) {
  std::string name = newName(fields, body_names_, "body");
  addBody(name, fields.pos());
  return name;
}

fs::path SceneBodyReader::existingFile(const config::YamlNode& node, const std::string& label,
                                       const char* expected) const {
  const std::string text = config::yamlText(node, file_, label);
  const fs::path path = (folder_ / text).lexically_normal();
  std::error_code ec;
  const auto status = fs::status(path, ec);
  if (fs::is_regular_file(status)) return path;
  const SourcePos pos{file_, node.line, node.column};
  if (fs::exists(status))
    throw ParseError(pos, "found " + std::string(fs::is_directory(status) ? "a folder" : "no regular file") +
                              " at " + path.string() + " for " + label + ", expected " + expected);
  throw ParseError(pos, "found no file " + path.string() + " for " + label + ", expected " + expected,
                   fs::path(text).is_absolute()
                       ? ""
                       : "the path is relative to the folder of the scene file, " + folder_.string());
}

template <class Body>
void SceneBodyReader::meshOrShape(const config::YamlFields& fields, Body& body) const {
  const auto* mesh = fields.find("mesh");
  const auto* shape_node = fields.find("shape");
  const auto* structure = fields.find("structure");
  if (structure && (mesh || shape_node))
    throw ParseError(fields.keyPos("structure"), std::string("found `structure` beside `") +
                                                     (mesh ? "mesh" : "shape") +
                                                     "` in one body, expected one of them");
  if (!structure && !mesh == !shape_node)
    throw ParseError(shape_node ? fields.keyPos("shape") : fields.pos(),
                     std::string("found ") + (mesh ? "both" : "neither") +
                         " `mesh` and `shape` in one body, expected one of them");
  if (mesh) body.mesh = existingFile(*mesh, "`mesh`", "a mesh");
  if (shape_node) body.shape = shape(*shape_node, file_);
  if (structure) {
    body.structure = existingFile(*structure, "`structure`", "a structure file");
    for (const char* key : {"voxel", "point", "outer_layers"})
      if (fields.find(key))
        throw ParseError(
            fields.keyPos(key),
            "found `" + std::string(key) + "` beside `structure`, expected it beside a mesh or a shape",
            "the file of a structure says how fine it is");
  }
  if (!mesh && fields.find("scale"))
    throw ParseError(fields.keyPos("scale"),
                     std::string("found `scale` beside `") + (structure ? "structure" : "shape") +
                         "`, expected it beside a mesh only",
                     structure ? "" : "the sizes of a shape are in metres");
  body.scale = scale(fields);
}

/// A name that the scene does not write itself.
void SceneBodyReader::takeBody(const std::string& name, const SourcePos& pos) {
  if (name.find_first_of(",\"") != std::string::npos)
    throw ParseError(pos, "found the link name `" + name + "`, expected no comma and no quotation mark",
                     "names stand in the headers of CSV files");
  if (!body_names_.insert(name).second)
    throw ParseError(pos, "found the body name `" + name + "` that is taken already, expected a new one");
  addBody(name, pos);
}

/// `pose`, or the centre that the mechanism's file gives.
void placeLink(const config::YamlFields& fields, const mechanism::Mechanism& mechanism, LinkDescription& l) {
  const int index = mechanism.indexOf(l.frame);
  const mechanism::MechanismFrame* frame =
      index < 0 ? nullptr : &mechanism.frames[static_cast<std::size_t>(index)];
  const bool has_center = frame && frame->has_center;
  if (has_center) l.p_FC = frame->X_FC.translation();
  const auto* node = fields.find("pose");
  const bool at_center = node && node->kind == config::YamlNode::Kind::kScalar && node->text == "center";
  if (at_center && !has_center)
    throw ParseError(fields.pos(*node), "found `pose: center`, but the mechanism's file gives frame " +
                                            l.frame + " no centre, expected a `link` environment for it");
  l.posed = node && !at_center;
  if (l.posed)
    l.X_FL = pose(fields, "pose");
  else if (has_center && (at_center || l.shape))
    l.X_FL = frame->X_FC;
}

LinkDescription SceneBodyReader::link(const config::YamlNode& node, const mechanism::Mechanism& mechanism) {
  const config::YamlFields fields(node, file_, "a link",
                                  {"name", "frame", "mesh", "scale", "shape", "structure", "pose", "held",
                                   "voxel", "point", "outer_layers", "margin", "max_speed"});
  LinkDescription l;
  l.pos = fields.pos();
  l.name = newBody(fields);
  const config::YamlNode& frame = fields.need("frame");
  l.frame = config::yamlText(frame, file_, "`frame`");
  if (mechanism.indexOf(l.frame) < 0 && l.frame != "0") {
    std::vector<std::string> names;
    for (const auto& f : mechanism.frames) names.push_back(f.name);
    throw ParseError(
        fields.pos(frame),
        "found " + config::yamlFound(frame) + " for `frame`, expected 0 or a frame of the mechanism's file",
        config::nearestHint(l.frame, names));
  }
  meshOrShape(fields, l);
  placeLink(fields, mechanism, l);
  l.held = flag(fields, "held");
  l.settings = settings(fields);
  return l;
}

control::ReactionDescription SceneBodyReader::reaction(const config::YamlNode& node, int dof) const {
  control::ReactionDescription r = control::readReaction(node, file_);
  const SourcePos pos{file_, node.line, node.column};
  if (dof == 0)
    throw ParseError(pos, "found `reaction` for a mechanism that nothing moves, expected one with a `dof`");
  try {
    const control::Reaction fits(r, dof, 0);
  } catch (const UsageError& e) {
    throw ParseError(pos, e.what());
  }
  return r;
}

/// The law `proxy` moves one held link.
void requireHeld(const config::YamlFields& fields, const MechanismDescription& m) {
  const LinkDescription* held = nullptr;
  for (const LinkDescription& l : m.links) {
    if (!l.held) continue;
    if (held) throw ParseError(l.pos, "found a second link with `held: true`, expected one at most");
    held = &l;
  }
  if (m.reaction && m.reaction->proxy && !held)
    throw ParseError(fields.pos(fields.need("reaction")),
                     "found `proxy` and nothing that is held, expected one of the `links` with `held: true`");
}

/// `bodiless`: frames of the mechanism, or 0 for its base.
std::vector<std::string> bodilessFrames(const config::YamlFields& fields,
                                        const mechanism::Mechanism& mechanism) {
  std::vector<std::string> names, known{"0"};
  for (const auto& f : mechanism.frames) known.push_back(f.name);
  for (const auto& node : fields.list("bodiless")) {
    names.push_back(config::yamlText(node, fields.file(), "`bodiless`"));
    if (std::find(known.begin(), known.end(), names.back()) == known.end())
      throw ParseError(fields.pos(node),
                       "found " + config::yamlFound(node) +
                           " in `bodiless`, expected 0 or a frame of the mechanism's file",
                       config::nearestHint(names.back(), known));
  }
  return names;
}

MechanismDescription SceneBodyReader::mechanism(const config::YamlNode& node) {
  const config::YamlFields fields(
      node, file_, "a mechanism",
      {"name", "file", "base", "q", "motion", "links", "geometry", "bodiless", "srdf", "reaction", "voxel",
       "point", "outer_layers", "margin", "max_speed"});
  MechanismDescription m;
  m.pos = fields.pos();
  m.name = newName(fields, groups_, "group");
  m.file = existingFile(fields.need("file"), "`file`", "a mechanism (.mech or .urdf)");
  m.X_WB = pose(fields, "base");
  for (const auto& q : fields.list("q")) m.q.push_back(config::yamlNumber(q, file_, "`q`", kJointRange));
  if (const auto* motion = fields.find("motion"))
    m.motion = existingFile(*motion, "`motion`", "a CSV of joint values");
  m.settings = settings(fields);
  if (const auto* srdf = fields.find("srdf")) m.srdf = existingFile(*srdf, "`srdf`", "an SRDF");
  const robot_file::Robot robot = robot_file::loadRobot(m.file);
  remarks_.insert(remarks_.end(), robot.warnings.begin(), robot.warnings.end());
  if (const auto* node_reaction = fields.find("reaction"))
    m.reaction = reaction(*node_reaction, robot.mechanism.dof);
  for (const auto& l : fields.list("links")) m.links.push_back(link(l, robot.mechanism));
  requireHeld(fields, m);
  const auto geometry = fields.choice("geometry", {"collision", "visual", "none"});
  m.bodiless = bodilessFrames(fields, robot.mechanism);
  m.no_geometry = geometry == "none";
  const std::vector<std::string> shown = framesWithGeometry(robot, m.bodiless);
  m.frames_with_geometry = shown.size();
  if (fields.find("links")) {
    if (geometry)
      throw ParseError(
          fields.keyPos("geometry"),
          "found `geometry` beside `links`, expected one of them: `links` say what each link is");
    for (const auto& frame : shown)
      if (std::none_of(m.links.begin(), m.links.end(), [&](const auto& l) { return l.frame == frame; }))
        m.missing.push_back({frame, "not among the scene's `links`"});
    if (!m.missing.empty()) remarks_.push_back(missingBodiesText(m));
    takeDisabled(m);
    return m;
  }
  if (m.no_geometry) return m;
  RobotLinks links = robotLinks(
      robot, m.name,
      geometry == "visual" ? robot_file::GeometryUse::kVisual : robot_file::GeometryUse::kCollision,
      packages_, m.bodiless);
  for (auto& l : links.links) takeBody(l.name, l.pos);
  m.links = std::move(links.links);
  m.missing = std::move(links.missing);
  if (!m.missing.empty()) remarks_.push_back(missingBodiesText(m));
  remarks_.insert(remarks_.end(), links.remarks.begin(), links.remarks.end());
  takeDisabled(m);
  return m;
}

/// Pairs of links become pairs of all bodies that hang on them.
void SceneBodyReader::takeDisabled(const MechanismDescription& mechanism) {
  if (mechanism.srdf.empty()) return;
  const robot_file::Srdf srdf = robot_file::loadSrdf(mechanism.srdf);
  std::map<std::string, std::vector<std::string>> bodies_on;
  for (const auto& link : mechanism.links) bodies_on[link.frame].push_back(link.name);
  for (const auto& pair : srdf.disabled)
    for (const auto& a : bodies_on[pair.link1])
      for (const auto& b : bodies_on[pair.link2]) dropped_.push_back({a, b, pair.reason});
}

RecordingDescription SceneBodyReader::recording(const config::YamlNode& node) {
  const config::YamlFields fields(
      node, file_, "`recording`",
      {"file", "format", "units", "up", "rate", "mirror", "joint_map", "marker_set", "place", "cut_things"});
  RecordingDescription r;
  r.pos = fields.pos();
  r.file = existingFile(fields.need("file"), "`file`", "a recording");
  r.format = fields.text("format").value_or(r.format);
  if (const auto* units = fields.find("units")) {
    if (units->kind == config::YamlNode::Kind::kScalar && parseDouble(units->text))
      config::yamlNumber(*units, file_, "`units`", kScaleRange);
    r.units = config::yamlText(*units, file_, "`units`");
  }
  r.up = fields.choice("up", {"auto", "x", "y", "z", "-x", "-y", "-z"}).value_or(r.up);
  r.rate = fields.number("rate", kRateRange).value_or(r.rate);
  r.mirror = fields.choice("mirror", {"none", "axes", "sides"}).value_or(r.mirror);
  if (const auto* map = fields.find("joint_map"))
    r.joint_map = existingFile(*map, "`joint_map`", "a joint map");
  if (const auto* set = fields.find("marker_set")) {
    r.marker_set = config::yamlText(*set, file_, "`marker_set`");
    if (r.marker_set != "auto" && r.marker_set != "none")
      r.marker_set = existingFile(*set, "`marker_set`", "auto, none or a marker set").string();
  }
  r.cut_things = flag(fields, "cut_things");
  if (const auto* place = fields.find("place")) {
    const config::YamlFields p(*place, file_, "`place`", {"xyz", "yaw"});
    r.place_xyz = p.vector("xyz", kPositionRange).value_or(r.place_xyz);
    r.place_yaw = p.number("yaw", kAngleRange).value_or(0.0);
  }
  return r;
}

HumanDescription SceneBodyReader::human(const config::YamlNode& node) {
  const config::YamlFields fields(node, file_, "a human",
                                  {"name", "height", "mass", "sex", "preset", "lengths", "parts", "recording",
                                   "voxel", "point", "outer_layers", "margin", "max_speed"});
  HumanDescription h;
  h.pos = fields.pos();
  h.name = newName(fields, groups_, "group");
  for (const auto& part : humanPartNames()) {
    std::string body = h.name + "/" + part;
    if (!body_names_.insert(body).second)
      throw ParseError(fields.pos(fields.need("name")),
                       "found the body `" + body + "` a second time, expected another name for the human");
    addBody(std::move(body), h.pos);
  }
  h.height = fields.number("height", kHeightRange).value_or(h.height);
  h.mass = fields.number("mass", kMassRange);
  h.sex = fields.choice("sex", {"f", "m"});
  h.preset = fields.choice("preset", {"anthropometric", "thesis"}).value_or(h.preset);
  h.follow_lengths = fields.choice("lengths", {"model", "recording"}).value_or("model") == "recording";
  h.settings = settings(fields);
  if (const auto* parts = fields.find("parts")) {
    const config::YamlFields known(*parts, file_, "`parts`", humanPartNames());
    for (std::size_t i = 0; i < parts->keys.size(); ++i)
      h.parts[parts->keys[i].text] = humanPart(parts->items[i], file_, parts->keys[i].text);
  }
  if (const auto* node_recording = fields.find("recording")) h.recording = recording(*node_recording);
  return h;
}

ObjectDescription SceneBodyReader::object(const config::YamlNode& node) {
  const config::YamlFields fields(node, file_, "an object",
                                  {"name", "mesh", "scale", "shape", "structure", "pose", "mass", "voxel",
                                   "point", "outer_layers", "margin", "max_speed"});
  ObjectDescription o;
  o.pos = fields.pos();
  o.name = newBody(fields);
  meshOrShape(fields, o);
  o.X_WB = pose(fields, "pose");
  o.mass = fields.number("mass", kThingMassRange);
  o.settings = settings(fields);
  return o;
}

}  // namespace abstand::scene_file
