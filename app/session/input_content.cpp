#include "app/session/input_content.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"

namespace abstand::session {
namespace {

constexpr std::uintmax_t kMaxInputBytes = std::uintmax_t{1} << 30;
constexpr std::size_t kBlockBytes = std::size_t{1} << 20;

void addSized(ContentHash& hash, const std::string& text) {
  hash.add(text.size());
  hash.add(text.data(), text.size());
}

/// Size and bytes of a file, block by block: recordings may be large.
void addFile(ContentHash& hash, const std::filesystem::path& file) {
  needRegularFile(file);
  const SourcePos pos{file.string()};
  std::error_code ec;
  const std::uintmax_t bytes = std::filesystem::file_size(file, ec);
  if (ec) throw ParseError(pos, "cannot be read: " + ec.message());
  if (bytes == 0) throw ParseError(pos, "the file is empty");
  if (bytes > kMaxInputBytes)
    throw ParseError(
        pos, "found " + std::to_string(bytes) + " bytes, expected at most " + std::to_string(kMaxInputBytes));
  hash.add(static_cast<std::size_t>(bytes));
  std::ifstream in(file, std::ios::binary);
  std::vector<char> block(kBlockBytes);
  for (std::uintmax_t left = bytes; left > 0;) {
    const auto count = static_cast<std::size_t>(std::min<std::uintmax_t>(left, block.size()));
    if (!in.read(block.data(), static_cast<std::streamsize>(count)))
      throw ParseError(pos, "cannot be read, expected a readable file");
    hash.add(block.data(), count);
    left -= count;
  }
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
  addFile(hash, file);
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
  for (const auto& h : scene.humans) {
    add(h.recording.file), add(h.recording.options.joint_map);
    for (const auto& tool : h.tools) add(tool.mesh), add(tool.structure);
  }
  return files;
}

}  // namespace abstand::session
