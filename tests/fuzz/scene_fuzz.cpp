// Fuzzes the scene reader: only ParseError may come out, and what was understood reads back the same.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "app/scene_file/scene_description.hpp"
#include "core/base/error.hpp"

namespace {

/// A folder with one file that the corpus names for every mesh, mechanism and recording.
std::filesystem::path sceneFile() {
  const auto folder = std::filesystem::temp_directory_path() / "abstand-scene-fuzz";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "f") << "mapping\ndof 0 1\ndof 1 2\nend_mapping\nchain\nframe 1 0 0 0 theta\nframe "
                                 "2 0 90 0 theta\nend_chain\n";
  return folder / "scene.yaml";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto file = sceneFile();
  std::optional<abstand::scene_file::SceneDescription> scene;
  try {
    scene = abstand::scene_file::parseScene(std::string(reinterpret_cast<const char*>(data), size), file);
  } catch (const abstand::ParseError&) {
    return 0;
  }
  const auto again = abstand::scene_file::parseScene(abstand::scene_file::describeScene(*scene), file);
  ABSTAND_CHECK(again.objects.size() == scene->objects.size());
  ABSTAND_CHECK(again.humans.size() == scene->humans.size());
  ABSTAND_CHECK(again.mechanisms.size() == scene->mechanisms.size());
  for (std::size_t i = 0; i < again.mechanisms.size(); ++i)
    ABSTAND_CHECK(again.mechanisms[i].reaction.has_value() == scene->mechanisms[i].reaction.has_value());
  ABSTAND_CHECK(again.pairs.exclude == scene->pairs.exclude);
  ABSTAND_CHECK(again.pairs.include == scene->pairs.include);
  ABSTAND_CHECK(again.threads == scene->threads);
  return 0;
}
