#include "app/session/input_content.hpp"

#include <algorithm>

#include "core/base/text_file.hpp"

namespace abstand::session {
namespace {

constexpr std::size_t kMaxInputBytes = std::size_t{1} << 30;

void addSized(ContentHash& hash, const std::string& text) {
  hash.add(text.size());
  hash.add(text.data(), text.size());
}

}  // namespace

void addContent(ContentHash& hash, const std::filesystem::path& file) {
  if (file.empty()) return;
  if (std::error_code ec; std::filesystem::is_directory(file, ec)) {
    // A recording of depth images.
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(file))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& f : files) addSized(hash, f.filename().string()), addContent(hash, f);
    return;
  }
  addSized(hash, readFile(file, kMaxInputBytes));
}

std::vector<std::filesystem::path> inputFiles(const scene_file::SceneDescription& scene) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::filesystem::path& file) {
    if (!file.empty() && std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  };
  add(scene.file);
  for (const auto& m : scene.mechanisms) {
    add(m.file);
    add(m.motion);
    for (const auto& link : m.links) add(link.mesh), add(link.structure);
  }
  for (const auto& o : scene.objects) add(o.mesh), add(o.structure);
  for (const auto& h : scene.humans) add(h.recording.file), add(h.recording.options.joint_map);
  return files;
}

}  // namespace abstand::session
