#include "app/scene_file/scene_body_reader.hpp"

#include <system_error>

#include "app/scene_file/body_fields.hpp"

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
    throw ParseError(fields.keyPos("structure"), std::string("found `structure` together with `") +
                                                     (mesh ? "mesh" : "shape") +
                                                     "` in one body, expected one of them");
  if (!structure && !mesh == !shape_node)
    throw ParseError(shape_node ? fields.keyPos("shape") : fields.pos(),
                     std::string("found ") + (mesh ? "both" : "neither") +
                         " `mesh` and `shape` in one body, expected one of them");
  if (mesh) body.mesh = existingFile(*mesh, "`mesh`", "a mesh");
  if (shape_node) body.shape = readShape(*shape_node, file_);
  if (structure) {
    body.structure = existingFile(*structure, "`structure`", "a structure file");
    for (const char* key : {"voxel", "point", "outer_layers"})
      if (fields.find(key))
        throw ParseError(
            fields.keyPos(key),
            "found `" + std::string(key) + "` together with `structure`, expected it with a mesh or a shape",
            "the structure file sets its resolution");
  }
  if (!mesh && fields.find("scale"))
    throw ParseError(fields.keyPos("scale"),
                     std::string("found `scale` together with `") + (structure ? "structure" : "shape") +
                         "`, expected it with a mesh only",
                     structure ? "" : "the sizes of a shape are in metres");
  body.scale = readScale(fields);
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
template void SceneBodyReader::meshOrShape(const config::YamlFields&, LinkDescription&) const;

ObjectDescription SceneBodyReader::object(const config::YamlNode& node) {
  const config::YamlFields fields(node, file_, "an object",
                                  {"name", "mesh", "scale", "shape", "structure", "pose", "mass", "voxel",
                                   "point", "outer_layers", "margin", "max_speed"});
  ObjectDescription o;
  o.pos = fields.pos();
  o.name = newBody(fields);
  meshOrShape(fields, o);
  o.X_WB = readPose(fields, "pose");
  o.mass = fields.number("mass", kThingMassRange);
  o.settings = readSettings(fields);
  return o;
}

}  // namespace abstand::scene_file
