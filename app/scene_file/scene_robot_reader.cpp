#include <algorithm>
#include <map>

#include "app/scene_file/body_fields.hpp"
#include "app/scene_file/robot_links.hpp"
#include "app/scene_file/scene_body_reader.hpp"
#include "core/control/reaction.hpp"
#include "core/control/reaction_reader.hpp"
#include "core/robot_file/srdf_file.hpp"

namespace abstand::scene_file {
namespace {

constexpr config::YamlRange kJointRange{-1e6, 1e6};

}  // namespace

/// Sets the pose from `pose`, or from the centre in the mechanism's file.
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
    l.X_FL = readPose(fields, "pose");
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
  readMeshOrShape(fields, finder(), l);
  placeLink(fields, mechanism, l);
  l.held = readFlag(fields, "held");
  l.settings = readSettings(fields);
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

/// The law `proxy` needs exactly one held link.
void requireHeld(const config::YamlFields& fields, const MechanismDescription& m) {
  const LinkDescription* held = nullptr;
  for (const LinkDescription& l : m.links) {
    if (!l.held) continue;
    if (held) throw ParseError(l.pos, "found a second link with `held: true`, expected at most one");
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
  m.X_WB = readPose(fields, "base");
  for (const auto& q : fields.list("q")) m.q.push_back(config::yamlNumber(q, file_, "`q`", kJointRange));
  if (const auto* motion = fields.find("motion"))
    m.motion = existingFile(*motion, "`motion`", "a CSV of joint values");
  m.settings = readSettings(fields);
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
      throw ParseError(fields.keyPos("geometry"),
                       "found `geometry` together with `links`, expected one of them: `links` defines the "
                       "geometry of each link");
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
  takeLinks(std::move(links), m, remarks_);
  takeDisabled(m);
  return m;
}

/// Converts disabled pairs of links into pairs of all their bodies.
void SceneBodyReader::takeDisabled(const MechanismDescription& mechanism) {
  if (mechanism.srdf.empty()) return;
  const robot_file::Srdf srdf = robot_file::loadSrdf(mechanism.srdf);
  std::map<std::string, std::vector<std::string>> bodies_on;
  for (const auto& link : mechanism.links) bodies_on[link.frame].push_back(link.name);
  for (const auto& pair : srdf.disabled)
    for (const auto& a : bodies_on[pair.link1])
      for (const auto& b : bodies_on[pair.link2]) dropped_.push_back({a, b, pair.reason});
}

}  // namespace abstand::scene_file
