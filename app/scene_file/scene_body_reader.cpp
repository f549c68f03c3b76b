#include "app/scene_file/scene_body_reader.hpp"

#include "app/scene_file/body_fields.hpp"
#include "app/scene_file/mesh_or_shape.hpp"

namespace abstand::scene_file {
namespace {

namespace fs = std::filesystem;

constexpr config::YamlRange kThingMassRange{0.0, 1e5, "kg", true};

}  // namespace

std::string SceneBodyReader::newName(const config::YamlFields& fields, std::set<std::string>& taken,
                                     const char* kind) {
  const config::YamlNode& node = fields.need("name");
  const std::string name = config::yamlText(node, file_, "`name`");
  if (name.find_first_of(",\"") != std::string::npos || name.front() == ' ' || name.back() == ' ')
    throw ParseError(fields.pos(node),
                     "found " + config::yamlFound(node) +
                         " for `name`, expected no comma, no quotation mark and no outer blanks",
                     "names are used in the headers of CSV files");
  if (!taken.insert(name).second)
    throw ParseError(
        fields.pos(node),
        "found the " + std::string(kind) + " name " + config::yamlFound(node) +
            " that is already used, expected a new one",
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
  return scene_file::existingFile(node, {file_, folder_}, label, expected);
}

FindFile SceneBodyReader::finder() const {
  return [this](const config::YamlNode& node, const std::string& label, const char* expected) {
    return existingFile(node, label, expected);
  };
}

/// Registers a name that is not written in the scene file.
void SceneBodyReader::takeBody(const std::string& name, const SourcePos& pos) {
  if (name.find_first_of(",\"") != std::string::npos)
    throw ParseError(pos, "found the link name `" + name + "`, expected no comma and no quotation mark",
                     "names are used in the headers of CSV files");
  if (!body_names_.insert(name).second)
    throw ParseError(pos, "found the body name `" + name + "` that is already used, expected a new one");
  addBody(name, pos);
}

ObjectDescription SceneBodyReader::object(const config::YamlNode& node) {
  const config::YamlFields fields(node, file_, "an object",
                                  {"name", "mesh", "scale", "shape", "structure", "pose", "mass", "voxel",
                                   "point", "outer_layers", "margin", "max_speed"});
  ObjectDescription o;
  o.pos = fields.pos();
  o.name = newBody(fields);
  readMeshOrShape(fields, finder(), o);
  o.X_WB = readPose(fields, "pose");
  o.mass = fields.number("mass", kThingMassRange);
  o.settings = readSettings(fields);
  return o;
}

}  // namespace abstand::scene_file
