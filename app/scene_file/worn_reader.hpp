// Reads clothing and tools of people, in scenes and plans.
#pragma once

#include "app/scene_file/mesh_or_shape.hpp"
#include "app/scene_file/scene_description.hpp"

namespace abstand::scene_file {

/// The map `clothing`: `preset` (one name, or a list) and parts with their thickness (m). Where several cover
/// a part, the thickest counts. Throws ParseError.
humanmodel::Clothing readClothing(const config::YamlNode& node, const std::string& file);

/// One tool. Throws ParseError.
ToolDescription readTool(const config::YamlNode& node, const std::string& file, const FindFile& find);

}  // namespace abstand::scene_file
