// What the files of a scene hold, as fingerprints.
#pragma once

#include <filesystem>
#include <vector>

#include "app/scene_file/scene_description.hpp"
#include "core/base/content_hash.hpp"

namespace abstand::session {

/// Adds what a file holds; of a folder, all of its files with their names; of no name, nothing. Throws
/// ParseError.
void addContent(ContentHash& hash, const std::filesystem::path& file);

/// The scene file and every file that it names, in the order of the scene, each once.
std::vector<std::filesystem::path> inputFiles(const scene_file::SceneDescription& scene);

}  // namespace abstand::session
