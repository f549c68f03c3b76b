// Writes a scene description as YAML.
#include <cstdio>

#include "app/scene_file/scene_description.hpp"
#include "core/base/number.hpp"
#include "core/control/reaction_reader.hpp"
#include "core/math/roll_pitch_yaw.hpp"

namespace abstand::scene_file {
namespace {

/// A YAML scalar in double quotes.
std::string escaped(const std::string& text) {
  std::string s = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') s += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(c));
      s += code;
    } else {
      s += c;
    }
  }
  return s + '"';
}

/// Unquoted if YAML reads it back as exactly this text.
std::string scalar(const std::string& text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  bool plain = !text.empty() && letter(text.front());
  for (const char c : text)
    plain = plain && (letter(c) || (c >= '0' && c <= '9') || c == '/' || c == '.' || c == '-');
  return plain && text != "null" && text != "Null" && text != "NULL" ? text : escaped(text);
}

std::string vector(const Vector3d& v) {
  return "[" + formatDouble(v.x()) + ", " + formatDouble(v.y()) + ", " + formatDouble(v.z()) + "]";
}

std::string pose(const Transform& X) {
  return "{xyz: " + vector(X.translation()) + ", rpy: " + vector(neatRollPitchYaw(X.linear())) + "}";
}

struct ShapeText {
  std::string operator()(const geometry::Sphere& s) const {
    return "{sphere: {radius: " + formatDouble(s.radius) + "}}";
  }
  std::string operator()(const geometry::Ellipsoid& s) const {
    return "{ellipsoid: {semi_axes: " + vector(s.semi_axes) + "}}";
  }
  std::string operator()(const geometry::Cuboid& s) const {
    return "{cuboid: {size: " + vector(s.size) + "}}";
  }
  std::string operator()(const geometry::Cylinder& s) const { return round("cylinder", s.radius, s.length); }
  std::string operator()(const geometry::Capsule& s) const { return round("capsule", s.radius, s.length); }
  static std::string round(const char* name, double radius, double length) {
    return std::string("{") + name + ": {radius: " + formatDouble(radius) +
           ", length: " + formatDouble(length) + "}}";
  }
};

/// Each setting between `before` and `after`.
std::string settings(const BodySettings& s, const char* before = ", ", const char* after = "") {
  std::string t;
  if (s.voxel) t += before + ("voxel: " + formatDouble(*s.voxel)) + after;
  if (s.point) t += before + ("point: " + formatDouble(*s.point)) + after;
  if (s.outer_layers) t += before + ("outer_layers: " + std::to_string(*s.outer_layers)) + after;
  if (s.margin) t += before + ("margin: " + formatDouble(*s.margin)) + after;
  if (s.max_speed) t += before + ("max_speed: " + formatDouble(*s.max_speed)) + after;
  return t;
}

std::string scaleText(const Vector3d& scale) {
  return scale.x() > 0.0 && scale == Vector3d::Constant(scale.x()) ? formatDouble(scale.x()) : vector(scale);
}

template <class Body>
std::string meshOrShape(const Body& body) {
  if (body.shape) return ", shape: " + std::visit(ShapeText{}, *body.shape);
  if (!body.structure.empty()) return ", structure: " + scalar(body.structure.string());
  return ", mesh: " + scalar(body.mesh.string()) + ", scale: " + scaleText(body.scale);
}

/// A frame's name; ids of .mech files stay numbers.
std::string frameText(const std::string& frame) { return parseInt(frame) ? frame : scalar(frame); }

std::string mechanismText(const MechanismDescription& m) {
  std::string s = "  - name: " + scalar(m.name) + "\n    file: " + scalar(m.file.string()) +
                  "\n    base: " + pose(m.X_WB) + "\n";
  if (!m.q.empty()) {
    s += "    q: [";
    for (std::size_t i = 0; i < m.q.size(); ++i) s += (i ? ", " : "") + formatDouble(m.q[i]);
    s += "]\n";
  }
  if (!m.motion.empty()) s += "    motion: " + scalar(m.motion.string()) + "\n";
  s += settings(m.settings, "    ", "\n");
  if (!m.srdf.empty()) s += "    srdf: " + scalar(m.srdf.string()) + "\n";
  if (m.reaction) s += "    reaction:\n" + control::describeReaction(*m.reaction, "      ");
  if (!m.bodiless.empty()) {
    s += "    bodiless: [";
    for (std::size_t i = 0; i < m.bodiless.size(); ++i) s += (i ? ", " : "") + frameText(m.bodiless[i]);
    s += "]\n";
  }
  if (m.no_geometry) return s + "    geometry: none\n";
  s += m.links.empty() ? "    links: []\n" : "    links:\n";
  for (const auto& l : m.links)
    s += "      - {name: " + scalar(l.name) + ", frame: " + frameText(l.frame) + meshOrShape(l) +
         ", pose: " + pose(l.X_FL) + (l.held ? ", held: true" : "") + settings(l.settings) + "}\n";
  return s;
}

/// Defaults are omitted.
std::string recordingText(const RecordingDescription& r) {
  std::string said;
  if (r.options.rate > 0.0) said += ", rate: " + formatDouble(r.options.rate);
  if (r.options.mirror != "none") said += ", mirror: " + r.options.mirror;
  if (!r.options.joint_map.empty()) said += ", joint_map: " + scalar(r.options.joint_map.string());
  if (r.options.marker_set != "auto") said += ", marker_set: " + scalar(r.options.marker_set);
  if (!r.options.repair) said += ", repair: false";
  if (r.cut_things) said += std::string(", cut_things: ") + (*r.cut_things ? "true" : "false");
  return "    recording: {file: " + scalar(r.file.string()) + ", format: " + scalar(r.options.format) +
         ", units: " + (parseDouble(r.options.units) ? r.options.units : scalar(r.options.units)) +
         ", up: " + scalar(r.options.up) + said + ", place: {xyz: " + vector(r.place_xyz) +
         ", yaw: " + formatDouble(r.place_yaw) + "}}\n";
}

/// In the order of the keys.
std::string partText(const humanmodel::PartOverride& sizes, const BodySettings& own) {
  std::string s;
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) s += (s.empty() ? "" : ", ") + std::string(key) + ": " + formatDouble(*value);
  };
  add("breadth", sizes.breadth);
  add("contour", sizes.contour);
  add("depth", sizes.depth);
  add("length", sizes.length);
  add("margin", own.margin);
  add("max_speed", own.max_speed);
  add("point", own.point);
  add("voxel", own.voxel);
  if (sizes.shape) s += (s.empty() ? "shape: " : ", shape: ") + *sizes.shape;
  return "{" + s + "}";
}

std::string wornText(const HumanDescription& h) {
  std::map<std::string_view, double> clothing;
  for (const auto& [part, thickness] : h.body.clothing) clothing[humanmodel::partName(part)] = thickness;
  std::string s;
  for (const auto& [part, thickness] : clothing)
    s += (s.empty() ? "    clothing: {" : ", ") + std::string(part) + ": " + formatDouble(thickness);
  if (!s.empty()) s += "}\n";
  if (!h.tools.empty()) s += "    tools:\n";
  for (const ToolDescription& t : h.tools)
    s += "      - {name: " + scalar(t.name) +
         ", hand: " + (t.hand == humanmodel::BodyPart::kHandLeft ? "left" : "right") + meshOrShape(t) +
         ", pose: " + pose(t.X_HT) + settings(t.settings) + "}\n";
  return s;
}

std::string humanText(const HumanDescription& h) {
  const humanmodel::HumanOptions& body = h.body;
  std::string s = "  - name: " + scalar(h.name) + "\n";
  if (body.height) s += "    height: " + formatDouble(*body.height) + "\n";
  if (body.mass) s += "    mass: " + formatDouble(*body.mass) + "\n";
  if (body.percentile) s += "    percentile: " + formatDouble(*body.percentile) + "\n";
  if (body.sex) s += std::string("    sex: ") + (*body.sex == humanmodel::Sex::kFemale ? "f" : "m") + "\n";
  s += std::string("    preset: ") +
       (body.preset == humanmodel::HumanPreset::kThesis ? "thesis" : "anthropometric") +
       "\n    lengths: " + (h.follow_lengths ? "recording" : "model") + "\n";
  s += settings(h.settings, "    ", "\n");
  std::map<std::string_view, std::string> parts;
  for (const auto& [part, own] : h.parts) {
    const auto sizes = body.overrides.find(part);
    parts[humanmodel::partName(part)] =
        partText(sizes == body.overrides.end() ? humanmodel::PartOverride() : sizes->second, own);
  }
  if (!parts.empty()) s += "    parts:\n";
  for (const auto& [name, text] : parts) s += "      " + std::string(name) + ": " + text + "\n";
  std::string clamped;
  for (const humanmodel::BodyPart part : h.clamped)
    clamped += (clamped.empty() ? "" : ", ") + std::string(humanmodel::partName(part));
  if (!clamped.empty()) s += "    clamped: [" + clamped + "]\n";
  s += wornText(h);
  return h.recording.file.empty() ? s : s + recordingText(h.recording);
}

/// Values without a limit are omitted.
std::string skippingText(const scene::QueryCulling& s) {
  std::string text = "skipping: {rest: " + formatDouble(s.rest);
  if (s.horizon < kInfinity) text += ", horizon: " + formatDouble(s.horizon);
  if (s.limited()) text += ", budget: " + formatDouble(s.budget);
  if (!s.remember) text += ", remember: false";
  if (s.far_tolerance != scene::QueryCulling{}.far_tolerance)
    text += ", tolerance: " + formatDouble(s.far_tolerance);
  return text + "}\n";
}

std::string pairList(const std::vector<std::pair<std::string, std::string>>& pairs) {
  std::string s = "[";
  for (std::size_t i = 0; i < pairs.size(); ++i)
    s += (i ? ", [" : "[") + scalar(pairs[i].first) + ", " + scalar(pairs[i].second) + "]";
  return s + "]";
}

}  // namespace

std::string describeScene(const SceneDescription& scene) {
  const auto& d = scene.defaults;
  std::string s = "abstand: 1\ndefaults: {voxel: " + formatDouble(d.haptic.voxel_size) +
                  ", point: " + formatDouble(d.haptic.point_spacing) +
                  ", outer_layers: " + std::to_string(d.haptic.outer_layers) +
                  ", field: " + std::string(structure::fieldName(d.haptic.field)) +
                  ", margin: " + formatDouble(d.margin) + ", stiffness: " + formatDouble(d.stiffness) +
                  ", law: " + (d.thesis_law ? "thesis" : "volume") + "}\n";
  if (!scene.mechanisms.empty()) s += "mechanisms:\n";
  for (const auto& m : scene.mechanisms) s += mechanismText(m);
  if (!scene.humans.empty()) s += "humans:\n";
  for (const auto& h : scene.humans) s += humanText(h);
  if (!scene.objects.empty()) s += "objects:\n";
  for (const auto& o : scene.objects)
    s += "  - {name: " + scalar(o.name) + meshOrShape(o) + ", pose: " + pose(o.X_WB) +
         (o.mass ? ", mass: " + formatDouble(*o.mass) : "") + settings(o.settings) + "}\n";
  const auto& p = scene.pairs;
  s += std::string("pairs:\n  default: ") +
       (p.standard == PairDefault::kAll    ? "all"
        : p.standard == PairDefault::kNone ? "none"
                                           : "between_groups") +
       (p.file.empty() ? "" : "\n  file: " + scalar(p.file.string())) +
       "\n  adjacent: " + (p.exclude_adjacent ? "exclude" : "include") +
       (p.within_people ? "\n  within_people: include" : "") + "\n  exclude: " + pairList(p.exclude) +
       "\n  include: " + pairList(p.include) + "\n";
  s += skippingText(scene.culling);
  if (scene.threads.empty()) return s + "threads: auto\n";
  s += "threads:\n";
  for (const auto& group : scene.threads) s += "  - " + pairList(group) + "\n";
  return s;
}

}  // namespace abstand::scene_file
