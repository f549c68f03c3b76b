#include "app/scene_file/worn_reader.hpp"

#include "app/scene_file/body_fields.hpp"
#include "core/base/error.hpp"

namespace abstand::scene_file {
namespace {

constexpr config::YamlRange kClothingRange{0.0, humanmodel::kMaxClothing, "m"};

void addPreset(const config::YamlNode& node, const std::string& file, humanmodel::Clothing& clothing) {
  const auto names = humanmodel::clothingPresets();
  const std::string name = config::yamlChoice(node, file, "`preset`", {names.begin(), names.end()});
  humanmodel::addClothingPreset(name, clothing);
}

}  // namespace

std::string ToolDescription::bodyName(const std::string& person) const {
  return person + "/" + std::string(humanmodel::partName(hand)) + "/" + name;
}

humanmodel::Clothing readClothing(const config::YamlNode& node, const std::string& file) {
  std::vector<std::string> keys{"preset"};
  for (const std::string_view part : humanmodel::partNames()) keys.emplace_back(part);
  const config::YamlFields fields(node, file, "`clothing`", keys);
  humanmodel::Clothing clothing;
  if (const auto* preset = fields.find("preset")) {
    if (preset->kind == config::YamlNode::Kind::kList)
      for (const config::YamlNode& one : preset->items) addPreset(one, file, clothing);
    else
      addPreset(*preset, file, clothing);
  }
  humanmodel::Clothing parts;
  for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i) {
    const auto part = static_cast<humanmodel::BodyPart>(i);
    if (const auto thickness = fields.number(humanmodel::partName(part), kClothingRange))
      parts[part] = *thickness;
  }
  humanmodel::addClothing(parts, clothing);
  return clothing;
}

ToolDescription readTool(const config::YamlNode& node, const std::string& file, const FindFile& find) {
  const config::YamlFields fields(node, file, "a tool",
                                  {"name", "hand", "mesh", "scale", "shape", "structure", "pose", "voxel",
                                   "point", "outer_layers", "margin", "max_speed"});
  ToolDescription tool;
  tool.pos = fields.pos();
  const config::YamlNode& name = fields.need("name");
  tool.name = config::yamlText(name, file, "`name`");
  if (tool.name.find_first_of(",\"/") != std::string::npos || tool.name.front() == ' ' ||
      tool.name.back() == ' ')
    throw ParseError(fields.pos(name),
                     "found " + config::yamlFound(name) +
                         " for `name`, expected no comma, slash or quotation mark and no outer blanks");
  fields.need("hand");
  tool.hand = *fields.choice("hand", {"left", "right"}) == "left" ? humanmodel::BodyPart::kHandLeft
                                                                  : humanmodel::BodyPart::kHandRight;
  readMeshOrShape(fields, find, tool);
  tool.X_HT = readPose(fields, "pose");
  tool.settings = readSettings(fields);
  return tool;
}

}  // namespace abstand::scene_file
