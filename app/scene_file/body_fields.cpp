#include "app/scene_file/body_fields.hpp"

namespace abstand::scene_file {
namespace {

constexpr config::YamlRange kStretchRange{-1e6, 1e6};
constexpr config::YamlRange kSizeRange{0.0, 1e3, "m", true};
constexpr config::YamlRange kCapsuleLengthRange{0.0, 1e3, "m"};

double needNumber(const config::YamlFields& fields, std::string_view key, const config::YamlRange& range) {
  fields.need(key);
  return *fields.number(key, range);
}

Vector3d needVector(const config::YamlFields& fields, std::string_view key, const config::YamlRange& range) {
  fields.need(key);
  return *fields.vector(key, range);
}

}  // namespace

bool readFlag(const config::YamlFields& fields, const char* key) {
  return fields.choice(key, {"true", "false"}).value_or("false") == "true";
}

Transform readPose(const config::YamlFields& parent, std::string_view key) {
  const auto* node = parent.find(key);
  if (!node) return Transform::Identity();
  const config::YamlFields fields(*node, parent.file(), "`" + std::string(key) + "`", {"xyz", "rpy"});
  return fromXyzRpy(fields.vector("xyz", kPositionRange).value_or(Vector3d::Zero()),
                    fields.vector("rpy", kAngleRange).value_or(Vector3d::Zero()));
}

Vector3d readScale(const config::YamlFields& fields) {
  const auto* node = fields.find("scale");
  if (!node || node->kind != config::YamlNode::Kind::kList)
    return Vector3d::Constant(fields.number("scale", kScaleRange).value_or(1.0));
  const Vector3d s = *fields.vector("scale", kStretchRange);
  if ((s.array() == 0.0).any())
    throw ParseError(fields.pos(*node), "found 0 in `scale`, expected numbers other than 0");
  return s;
}

BodySettings readSettings(const config::YamlFields& fields) {
  BodySettings s;
  s.voxel = fields.number("voxel", kVoxelRange);
  s.point = fields.number("point", kVoxelRange);
  s.margin = fields.number("margin", kMarginRange);
  s.outer_layers = fields.integer("outer_layers", 0, kMaxOuterLayers);
  s.max_speed = fields.number("max_speed", kSpeedRange);
  return s;
}

geometry::Shape readShape(const config::YamlNode& node, const std::string& file) {
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

}  // namespace abstand::scene_file
